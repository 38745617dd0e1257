/*
Contains parts of these packages, under their licences:

three 0.180.0

The MIT License

Copyright © 2010-2025 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

fflate 0.8.3

MIT License

Copyright (c) 2026 Arjun Barrett

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
"use strict";(()=>{var ci=Uint8Array,Ur=Uint16Array,zv=Int32Array,qd=new ci([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Yd=new ci([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Vv=new ci([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),$d=function(i,t){for(var e=new Ur(31),n=0;n<31;++n)e[n]=t+=1<<i[n-1];for(var s=new zv(e[30]),n=1;n<30;++n)for(var r=e[n];r<e[n+1];++r)
s[r]=r-e[n]<<5|n;return{b:e,r:s}},Zd=$d(qd,2),Jd=Zd.b,Hv=Zd.r;Jd[28]=258,Hv[258]=28;var Kd=$d(Yd,0),Gv=Kd.b,aE=Kd.r,ru=new Ur(32768);for(Ae=0;Ae<32768;++Ae)Ki=(Ae&43690)>>1|(Ae&21845)<<1,Ki=(Ki&52428)>>2|(Ki&13107)<<2,Ki=(Ki&61680)>>4|(Ki&3855)<<4,ru[Ae]=((Ki&65280)>>8|(Ki&255)<<8)>>1;var Ki,Ae,Xo=(function(i,t,e){for(var n=i.length,s=0,r=new Ur(t);s<n;++s)i[s]&&++r[i[s]-1];var o=new Ur(t);for(s=1;s<
t;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(e){a=new Ur(1<<t);var l=15-t;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=t-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[ru[h]>>l]=c}else for(a=new Ur(n),s=0;s<n;++s)i[s]&&(a[s]=ru[o[i[s]-1]++]>>15-i[s]);return a}),qo=new ci(288);for(Ae=0;Ae<144;++Ae)qo[Ae]=8;var Ae;for(Ae=144;Ae<256;++Ae)qo[Ae]=9;var Ae;for(Ae=256;Ae<280;++Ae)qo[Ae]=7;var Ae;for(Ae=280;Ae<288;++Ae)
qo[Ae]=8;var Ae,jd=new ci(32);for(Ae=0;Ae<32;++Ae)jd[Ae]=5;var Ae;var Wv=Xo(qo,9,1);var Xv=Xo(jd,5,1),iu=function(i){for(var t=i[0],e=1;e<i.length;++e)i[e]>t&&(t=i[e]);return t},_i=function(i,t,e){var n=t/8|0;return(i[n]|i[n+1]<<8)>>(t&7)&e},su=function(i,t){var e=t/8|0;return(i[e]|i[e+1]<<8|i[e+2]<<16)>>(t&7)},qv=function(i){return(i+7)/8|0},Yv=function(i,t,e){return(t==null||t<0)&&(t=0),(e==null||e>i.length)&&(e=i.length),new ci(i.subarray(t,e))};var $v=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],bi=function(i,t,e){var n=new Error(t||$v[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,bi),!e)throw n;return n},
Zv=function(i,t,e,n){var s=i.length,r=n?n.length:0;if(!s||t.f&&!t.l)return e||new ci(0);var o=!e,a=o||t.i!=2,l=t.i;o&&(e=new ci(s*3));var c=function(ne){var Pe=e.length;if(ne>Pe){var U=new ci(Math.max(Pe*2,ne));U.set(e),e=U}},u=t.f||0,h=t.p||0,f=t.b||0,d=t.l,g=t.d,v=t.m,m=t.n,p=s*8;do{if(!d){u=_i(i,h,1);var b=_i(i,h+1,3);if(h+=3,b)if(b==1)d=Wv,g=Xv,v=9,m=5;else if(b==2){var A=_i(i,h,31)+257,D=_i(i,
h+10,15)+4,F=A+_i(i,h+5,31)+1;h+=14;for(var w=new ci(F),S=new ci(19),R=0;R<D;++R)S[Vv[R]]=_i(i,h+R*3,7);h+=D*3;for(var O=iu(S),z=(1<<O)-1,W=Xo(S,O,1),R=0;R<F;){var X=W[_i(i,h,z)];h+=X&15;var T=X>>4;if(T<16)w[R++]=T;else{var q=0,Z=0;for(T==16?(Z=3+_i(i,h,3),h+=2,q=w[R-1]):T==17?(Z=3+_i(i,h,7),h+=3):T==18&&(Z=11+_i(i,h,127),h+=7);Z--;)w[R++]=q}}var j=w.subarray(0,A),rt=w.subarray(A);v=iu(j),m=iu(rt),
d=Xo(j,v,1),g=Xo(rt,m,1)}else bi(1);else{var T=qv(h)+4,_=i[T-4]|i[T-3]<<8,C=T+_;if(C>s){l&&bi(0);break}a&&c(f+_),e.set(i.subarray(T,C),f),t.b=f+=_,t.p=h=C*8,t.f=u;continue}if(h>p){l&&bi(0);break}}a&&c(f+131072);for(var ot=(1<<v)-1,vt=(1<<m)-1,bt=h;;bt=h){var q=d[su(i,h)&ot],pt=q>>4;if(h+=q&15,h>p){l&&bi(0);break}if(q||bi(2),pt<256)e[f++]=pt;else if(pt==256){bt=h,d=null;break}else{var se=pt-254;if(pt>
264){var R=pt-257,Kt=qd[R];se=_i(i,h,(1<<Kt)-1)+Jd[R],h+=Kt}var Q=g[su(i,h)&vt],tt=Q>>4;Q||bi(3),h+=Q&15;var rt=Gv[tt];if(tt>3){var Kt=Yd[tt];rt+=su(i,h)&(1<<Kt)-1,h+=Kt}if(h>p){l&&bi(0);break}a&&c(f+131072);var wt=f+se;if(f<rt){var zt=r-rt,xt=Math.min(rt,wt);for(zt+f<0&&bi(3);f<xt;++f)e[f]=n[zt+f]}for(;f<wt;++f)e[f]=e[f-rt]}}t.l=d,t.p=bt,t.b=f,t.f=u,d&&(u=1,t.m=v,t.d=g,t.n=m)}while(!u);return f!=
e.length&&o?Yv(e,0,f):e.subarray(0,f)};var Jv=new ci(0);var Kv=function(i,t){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&bi(6,"invalid zlib data"),(i[1]>>5&1)==+!t&&bi(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Qd(i,t){return Zv(i.subarray(Kv(i,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var jv=typeof TextDecoder<"u"&&new TextDecoder,Qv=0;try{jv.decode(Jv,{stream:!0}),Qv=1}catch{}var _t=(i,t)=>[i[0]+t[0],i[1]+t[1],i[2]+t[2]],Zt=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],yt=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],It=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],rn=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],xn=i=>Math.hypot(i[0],i[1],i[2]),Kn=i=>yt(i,1/(xn(i)||1)),Qa=i=>Kn(rn(Math.abs(i[0])<.9?[1,0,0]:[0,1,0],i));function ty(i,t){return[i[0]*t[0]-i[1]*t[1]-i[2]*t[2]-i[3]*
t[3],i[0]*t[1]+i[1]*t[0]+i[2]*t[3]-i[3]*t[2],i[0]*t[2]-i[1]*t[3]+i[2]*t[0]+i[3]*t[1],i[0]*t[3]+i[1]*t[2]-i[2]*t[1]+i[3]*t[0]]}function je(i,t){let e=[i[1],i[2],i[3]],n=yt(rn(e,t),2);return _t(_t(t,yt(n,i[0])),rn(e,n))}function tl(i,t,e){return{r:_t(i.r,je(i.q,t)),q:ty(i.q,e)}}function wn(i,t,e){return Math.min(e,Math.max(t,i))}function zi(i,t){let e=0,n=i.length-1;for(;e<n;){let s=e+n+1>>1;i[s]<=t?
e=s:n=s-1}return e}function ji(i,t,e){let n=t-i;if(!(n>0)||!Number.isFinite(n))return{step:1,values:[i]};let s=10**Math.floor(Math.log10(n/e));for(let r of[1,2,5,10,20]){let o=r*s,a=Math.ceil(i/o-1e-9),l=Math.floor(t/o+1e-9);if(l-a+1>e)continue;let c=[];for(let u=a;u<=l;++u)c.push(u*o+0);return{step:o,values:c}}return{step:n,values:[i]}}var ja="\u2212";function ou(i,t){if(i===0)return"0";let e=Math.
max(Math.abs(i),t);return e>=1e5||e<.001?Number(i.toPrecision(6)).toExponential().replace("e+","e").replace(/-/g,ja):i.toFixed(Math.max(0,-Math.floor(Math.log10(t)+1e-9))).replace("-",ja)}function He(i){if(!Number.isFinite(i))return Number.isNaN(i)?"\u2013":String(i);let t=Math.abs(i);return t!==0&&(t>=1e5||t<1e-4)?Number(i.toPrecision(4)).toExponential().replace("e+","e").replace(/-/g,ja):String(
Number(i.toPrecision(4))).replace("-",ja)}function tp(i){let[t,e]=i<.0095?[1e3,"mm"]:i<.95?[100,"cm"]:i<950?[1,"m"]:[.001,"km"];return`${Number((i*t).toPrecision(4))} ${e}`}var Ms=3,Yo=i=>i.state===Ms&&i.step>0?i.step:1;function Ss(i,t){let e=[i.t,...t.map(r=>r.t)].filter(r=>r.length),n=Math.min(...e.map(r=>r[0])),s=Math.max(...e.map(r=>r[r.length-1]));return n<=s?[n,s]:[0,0]}var Fr=class{absent(t,e){return t>=0&&this.comes(t)&&this.pose(t,e).q.every(n=>n===0)}get begin(){return this.count?this.t[0]:0}get end(){return this.count?this.t[this.count-1]:0}indexAt(t){return zi(
this.t,t)}rates(t,e){let n=Math.min(this.indexAt(e),Math.max(0,this.count-2)),s=Math.min(n+1,this.count-1),r=this.t[s]-this.t[n];if(!(r>0))return{v:[0,0,0],omega:[0,0,0]};let o=this.pose(t,this.t[n]),a=this.pose(t,this.t[s]);if(!o.q.some(p=>p)||!a.q.some(p=>p))return{v:[0,0,0],omega:[0,0,0]};let[l,c,u,h]=o.q,f=a.q,d=[f[0]*l+f[1]*c+f[2]*u+f[3]*h,f[1]*l-f[0]*c-f[2]*h+f[3]*u,f[2]*l-f[0]*u-f[3]*c+f[1]*
h,f[3]*l-f[0]*h-f[1]*u+f[2]*c],g=Math.hypot(d[1],d[2],d[3]),v=2*Math.atan2(g,d[0]),m=g>1e-12?v/g/r:2/r;return{v:[0,1,2].map(p=>(a.r[p]-o.r[p])/r),omega:[d[1],d[2],d[3]].map(p=>p*m)}}firstMoving(){for(let t=0;t<this.poses;++t)if(this.moves(t))return t;return-1}usualForce(){return this.usual(t=>t!==Ms)}usualImpact(){return this.usual(t=>t===Ms)}usual(t){let e=[],n=this.contactCount,s=Math.max(1,Math.
floor(n/5e3));for(let r=0;r<n;r+=s){let o=this.contactAt(r),a=Math.hypot(...o.F)*Yo(o);a>0&&Number.isFinite(a)&&t(o.state)&&e.push(a)}return e.sort((r,o)=>r-o),e.length?e[Math.floor(.9*(e.length-1))]:0}};async function ws(i){if(!i)return new Uint8Array(0);let t=atob(i),e=new Uint8Array(t.length);for(let s=0;s<t.length;++s)e[s]=t.charCodeAt(s);if(typeof DecompressionStream>"u")return Qd(e);let n=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(n).arrayBuffer())}var lu=i=>new DataView(i.buffer,i.byteOffset,i.byteLength);async function ip(i){
let t=lu(await ws(i));return Float64Array.from({length:t.byteLength/8},(e,n)=>t.getFloat64(8*n,!0))}async function au(i){let t=lu(await ws(i));return Float32Array.from({length:t.byteLength/4},(e,n)=>t.getFloat32(4*n,!0))}function ep(i,t,e,n){let s=new Uint16Array(t*e),r=t*e;for(let o=0;o<t;++o){let a=0,l=0,c=n[o];for(let u=0,h=o*e;u<e;++u,++h){let f=i[h]|i[r+h]<<8,d=f>>1^-(f&1);u===1&&(l=a);let g=d+
(c===0?0:c===1?a:2*a-l)&65535;s[u*t+o]=g,l=a,a=g}}return s}var Nr=12,ey=-32768,np=(i,t)=>i===ey?0:2**(i/t),Or=class i extends Fr{constructor(e,n,s,r,o,a,l,c,u){super();this.poses=e;this.t=n;this.lo=s;this.course=o;this.contact=l;this.steps=c;this.coding=u;this.coming=new Set;this.count=n.length,this.now=new Float32Array(7*e),this.varying=new Int32Array(7*e).fill(-1),this.step=new Float32Array(7*e),
this.columns=0;for(let h=0;h<7*e;++h)s[h]<r[h]&&(this.varying[h]=this.columns++,this.step[h]=(r[h]-s[h])/(h%7<3?u.placeSteps:u.turnSteps));for(let h=0;h<e;++h)this.count&&this.isAbsentAnywhere(h)&&this.coming.add(h);this.firstContact=new Uint32Array(a.length+1);for(let h=0;h<a.length;++h)this.firstContact[h+1]=this.firstContact[h]+a[h]}static async from(e){let[n,s,r,o,a,l,c]=await Promise.all([ip(
e.t),au(e.steps??""),au(e.ranges),ws(e.orders),ws(e.data),ws(e.contacts.counts),ws(e.contacts.data)]),u=v=>r.filter((m,p)=>p%2===v),h=ep(a,o.length,n.length,o),f=lu(l),d=Uint32Array.from({length:f.byteLength/4},(v,m)=>f.getUint32(4*m,!0)),g=ep(c,Nr,c.length/2/Nr,new Uint8Array(Nr));return new i(e.poses,n,u(0),u(1),h,d,new Int16Array(g.buffer),s,e)}get contactCount(){return this.contact.length/Nr}place(e){
let n=this.indexAt(e),s=Math.min(n+1,this.count-1),r=s>n?wn((e-this.t[n])/(this.t[s]-this.t[n]),0,1):0;return[n*this.columns,s*this.columns,r]}comes(e){return this.coming.has(e)}isAbsent(e,n){let s=0;for(let r=7*e+3;r<7*e+7;++r){let o=this.varying[r];s+=(o<0?this.lo[r]:this.lo[r]+this.step[r]*this.course[n+o])**2}return s<.25}isAbsentAnywhere(e){for(let n=7*e+3;n<7*e+7;++n){let s=this.step[n],r=this.
lo[n]+65536*this.step[n];if(this.lo[n]>s||r<-s)return!1}for(let n=0;n<this.count;++n)if(this.isAbsent(e,n*this.columns))return!0;return!1}sample(e){if(!this.count)return this.now;let[n,s,r]=this.place(e),{now:o,varying:a,lo:l,step:c,course:u}=this;for(let h=0;h<o.length;++h){let f=a[h];o[h]=f<0?l[h]:l[h]+c[h]*(u[n+f]+(u[s+f]-u[n+f])*r)}for(let h of this.coming){let{r:f,q:d}=this.pose(h,e);o.set([...f,
...d],7*h)}for(let h=3;h<o.length;h+=7){let f=Math.sqrt(o[h]**2+o[h+1]**2+o[h+2]**2+o[h+3]**2)||1;for(let d=h;d<h+4;++d)o[d]/=f}return o}pose(e,n){if(e<0||!this.count)return{r:[0,0,0],q:[1,0,0,0]};let s=this.place(n),[r,o]=s,a=s[2];if(this.coming.has(e)){if(this.isAbsent(e,r))return{r:[0,0,0],q:[0,0,0,0]};this.isAbsent(e,o)&&(a=0)}let l=h=>{let f=this.varying[7*e+h],d=this.lo[7*e+h];return f<0?d:d+
this.step[7*e+h]*(this.course[r+f]+(this.course[o+f]-this.course[r+f])*a)},c=[l(3),l(4),l(5),l(6)],u=Math.hypot(...c)||1;return{r:[l(0),l(1),l(2)],q:c.map(h=>h/u)}}moves(e){return e>=0&&[0,1,2,3,4,5,6].some(n=>this.varying[7*e+n]>=0)}stands(e,n,s){let r=7*e+n;return this.varying[r]<0&&(s===void 0||Math.abs(this.lo[r]-s)<1e-6)}contacts(e){let n=[];if(!this.count)return n;let s=this.indexAt(e);for(let r=this.
firstContact[s];r<this.firstContact[s+1];++r)n.push(this.decoded(r,s));return n}get knowsSteps(){return this.steps.some(e=>e>0)}contactAt(e){return this.decoded(e,zi(this.firstContact,e))}decoded(e,n){let s=this.contact.subarray(Nr*e,Nr*(e+1)),{box:r,placeSteps:o,octaveSteps:a}=this.coding.contacts,l=d=>r[2*d]+(r[2*d+1]-r[2*d])*(s[d]&65535)/o,c=Kn([s[3],s[4],s[5]]),u=Kn([s[3]+s[7],s[4]+s[8],s[5]+s[9]]),
h=np(s[6],a),f=np(s[11],a)*(h||1);return{r:[l(0),l(1),l(2)],n:c,F:yt(u,h),state:s[10],limit:f,step:this.steps[n]??0}}};async function el(i){return JSON.parse(new TextDecoder().decode(await ws(i.scene)))}async function nl(i){let t=new Map,e=i.run&&Array.isArray(i.run.signals)?i.run.signals:[];for(let o of e)t.set(o.name,o.unit);let n=await Promise.all(i.signals.map(o=>o.t===void 0?null:ip(o.t))),s=await Promise.
all(i.signals.map(o=>au(o.y))),r=new Float64Array(0);return i.signals.map((o,a)=>(r=n[a]??r,{name:o.name,unit:o.unit||t.get(o.name)||"",t:r,y:s[a]}))}var sp=i=>(i.includes('"')?i.match(/("([^"]|"")*"|[^,]*)(,|$)/g)??[]:i.split(",")).map(t=>t.replace(/,$/,"").replace(/^"(.*)"$/,"$1").replace(/""/g,'"'));async function rp(i){return new TextDecoder().decode(await ws(i)).split(`
`).filter(e=>e).map(sp)}var op=i=>({t:Number(i[0]),impact:i[1]==="impact",system:i[1]==="impact"||i[1]==="switch"?"":i[1],contact:i[2],from:i[3],to:i[4],speed:Number(i[5]),impulse:Number(i[6])}),ap=i=>op(sp(i));async function il(i){let t=await rp(i.events),e=i.run?.settings,n=t.slice(1).filter(s=>s.length>=7).map(op);for(let s of ny(n,1.5*(e?.step??0)))s.brief=!0;return n}function ny(i,t){let e=new Map,
n=new Set;for(let s of i){let r=e.get(s.contact);r&&!s.system&&!s.impact&&!r.impact&&!n.has(r)&&s.t-r.t<=t&&r.from===s.to&&r.to===s.from&&n.add(r).add(s),e.set(s.contact,s)}return n}async function sl(i){let t=await rp(i.ledger),e=new Map;if(t.length<2)return e;let n=t.slice(1).filter(s=>s.length===t[0].length);return t[0].forEach((s,r)=>e.set(s,Float64Array.from(n,o=>Number(o[r])))),e}var $o=7,Js=11,iy=3e8,rl=class extends Fr{constructor(e){super();this.poses=e;this.frames=[];this.times=new Float64Array(0);this.bytes=0;this.marks=0;this.knowsSteps=!0;this.now=new Float32Array($o*e)}get count(){return this.frames.length}get t(){return this.times}get contactCount(){return this.marks}append(e){if(e.length){for(let n of e)this.frames.push(n),this.marks+=n.contacts.length/Js,this.bytes+=
4*(n.poses.length+n.contacts.length);this.bytes>iy&&this.thin(),this.times=Float64Array.from(this.frames,n=>n.t)}}thin(){let e=this.frames.length>>1;this.frames=this.frames.filter((n,s)=>s>=e||s%2===0),this.bytes=this.frames.reduce((n,s)=>n+4*(s.poses.length+s.contacts.length),0),this.marks=this.frames.reduce((n,s)=>n+s.contacts.length/Js,0)}place(e){let n=this.indexAt(e),s=this.frames[n],r=this.frames[Math.
min(n+1,this.count-1)];return[s,r,r.t>s.t?wn((e-s.t)/(r.t-s.t),0,1):0]}sample(e){if(!this.count)return this.now;for(let n=0;n<this.poses;++n){let{r:s,q:r}=this.pose(n,e);this.now.set([...s,...r],$o*n)}return this.now}pose(e,n){if(e<0||!this.count)return{r:[0,0,0],q:[1,0,0,0]};let s=this.place(n),[r,o]=s,a=$o*e;if(lp(r.poses,a))return{r:[0,0,0],q:[0,0,0,0]};let l=lp(o.poses,a)?0:s[2],c=0;for(let g=a+
3;g<a+7;++g)c+=r.poses[g]*o.poses[g];let u=c<0?-1:1,h=g=>r.poses[a+g]+((g<3?1:u)*o.poses[a+g]-r.poses[a+g])*l,f=[h(3),h(4),h(5),h(6)],d=Math.hypot(...f)||1;return{r:[h(0),h(1),h(2)],q:f.map(g=>g/d)}}comes(){return!0}moves(e){return e>=0}stands(e,n,s){let r=$o*e+n,o=s??this.frames[0]?.poses[r]??0;return this.frames.every(a=>Math.abs(a.poses[r]-o)<1e-6)}contacts(e){if(!this.count)return[];let{contacts:n,
step:s}=this.frames[this.indexAt(e)];return Array.from({length:n.length/Js},(r,o)=>cu(n,o,s))}contactAt(e){for(let{contacts:n,step:s}of this.frames){let r=n.length/Js;if(e<r)return cu(n,e,s);e-=r}return{r:[0,0,0],n:[0,0,1],F:[0,0,0],state:0,limit:0,step:0}}usualForce(){return this.latest(e=>e!==Ms)}usualImpact(){return this.latest(e=>e===Ms)}latest(e){let n=[];for(let{contacts:s,step:r}of this.frames.
slice(-300))for(let o=0;o<Math.min(s.length/Js,50);++o){let a=cu(s,o,r),l=Math.hypot(...a.F)*Yo(a);l>0&&e(a.state)&&n.push(l)}return n.sort((s,r)=>s-r),n.length?n[Math.floor(.9*(n.length-1))]:0}};function lp(i,t){return i[t+3]===0&&i[t+4]===0&&i[t+5]===0&&i[t+6]===0}function cu(i,t,e){let n=Js*t,s=r=>[i[n+r],i[n+r+1],i[n+r+2]];return{r:s(0),n:s(3),F:s(6),state:i[n+9],limit:i[n+10],step:e}}var ol=class{constructor(){
this.bytes=new Uint8Array(0);this.poses=-1}take(t){if(t.length){let r=new Uint8Array(this.bytes.length+t.length);r.set(this.bytes),r.set(t,this.bytes.length),this.bytes=r}let e=[],n=new DataView(this.bytes.buffer),s=0;if(this.poses<0){if(this.bytes.length<24||this.bytes.length<28+n.getUint32(20,!0))return e;this.poses=n.getUint32(16,!0),s=28+n.getUint32(20,!0)}for(;this.bytes.length>=s+40;){let r=Number(
n.getBigUint64(s+8,!0)),o=s+40;if(this.bytes.length<o+r)break;this.frames(n,o,n.getUint32(s+4,!0),e),s=o+r}return this.bytes=this.bytes.slice(s),e}frames(t,e,n,s){let r=(o,a)=>{let l=new Float32Array(a);for(let c=0;c<a;++c)l[c]=t.getFloat32(o+4*c,!0);return l};for(let o=0;o<n;++o){let a=t.getFloat64(e,!0),l=t.getUint32(e+8,!0),c=t.getFloat32(e+12,!0),u=$o*this.poses,h=Js*l;s.push({t:a,step:c,poses:r(
e+16,u),contacts:r(e+16+4*u,h)}),e+=16+4*(u+h)}}},Br=class{constructor(){this.text="";this.decoder=new TextDecoder;this.head=""}take(t){this.text+=this.decoder.decode(t,{stream:!0});let e=this.text.lastIndexOf(`
`);if(e<0)return[];let n=this.text.slice(0,e).split(`
`);return this.text=this.text.slice(e+1),this.head||(this.head=n.shift()??""),n}},kr=class{constructor(t){this.make=t;this.filled=0;this.room=t(256)}push(t){if(this.filled===this.room.length){let e=this.make(2*this.room.length);e.set(this.room),this.room=e}this.room[this.filled++]=t}thin(){let t=this.filled>>1,e=0;for(let n=0;n<this.filled;++n)(n>=t||n%2===0)&&(this.room[e++]=this.room[n]);this.filled=
e}get length(){return this.filled}get view(){return this.room.subarray(0,this.filled)}};var Zo=[.01,.02,.05,.1,.2,.5,1,2,5,10],hu={xz:"x\u2013z",xy:"x\u2013y",yz:"y\u2013z",iso:"3D"},uu='<svg viewBox="0 0 14 14"><path d="M2 0.5v13l11-6.5z"/></svg>',cp='<svg viewBox="0 0 14 14"><path d="M2 1h3.6v12H2zM8.4 1H12v12H8.4z"/></svg>',hp='<svg viewBox="0 0 16 16"><path d="M8 1a7 7 0 100 14A7 7 0 008 1zm0 1.5v11a5.5 5.5 0 010-11z"/></svg>',up=[["space","play, pause"],["\u2190 \u2192","one fra\
me back, on"],["shift \u2190 \u2192","a tenth of the film"],["n p","next, previous impact or switch"],["home end","first, last frame"],["+ \u2212","faster, slower"],["l","loop"],["1 2 3 4","view x\u2013z, x\u2013y, y\u2013z, 3D"],["0","fit"],["c t","contact forces, trails"],["[ ]","shorter, longer force arrows"],["b m","names of the bodies, measure"],["h shift h","hide the selected body, show all"],
["o w","another run over this one; beside it"],["f","follow what is selected, else the body the model names, else the first"],["s v","save the picture, a film"],["d","light, dark"],["drag","turn (3D) or move; with shift: move"],["wheel, two fingers","zoom"],["click","name, state and place of a body"],["in the curves","click: to this time; drag: zoom; double click: all"]];var fp={dark:!1,paper:"#ffffff",grid:"#eff1f4",gridZero:"#dde2e8",ink:"#1f2933",soft:"#5f6c7b",ground:"#f3f4f6",groundLine:"#d5dae0",hatch:"#9aa5b1",edge:"#3e4c59",accent:"#1769aa",sheet:"rgba(140, 150, 162, .10)",still:"#a9b2bd"},sy={dark:!0,paper:"#15191e",grid:"#1e242b",gridZero:"#303943",ink:"#e6eaee",soft:"#9aa7b4",ground:"#1c2229",groundLine:"#333d48",hatch:"#566270",edge:"#9aa7b4",accent:"#\
5aa9e6",sheet:"rgba(140, 150, 162, .14)",still:"#7f8b98"},jt=fp;function fu(i){jt=i?sy:fp}var Jo=["#3b82b8","#d9803b","#5a9e63","#a066b0","#c9a53a","#c75b62","#4aa3a2","#7d8794"],Qi=["#2b7bba","#d2601a","#3a9150","#9258b5","#b78a1c","#c2485c","#3a9d9c","#77828f"],En=[{name:"open",colour:"#8a94a0"},{name:"stick",colour:"#1f9d57"},{name:"slip",colour:"#e0701a"},{name:"impact",colour:"#d81b72"},{name:"\
spin",colour:"#8e5bd0"}];function Ye(i,t){let e=t>0?255:0,n=Math.abs(t),s=r=>{let o=parseInt(i.slice(r,r+2),16);return Math.round(o+(e-o)*n).toString(16).padStart(2,"0")};return"#"+s(1)+s(3)+s(5)}function Es(i){if(i.colour&&/^#[0-9a-f]{6}$/i.test(i.colour))return i.colour;if(i.colour){let t=document.createElement("canvas").getContext("2d");if(t){t.fillStyle="#010203",t.fillStyle=i.colour;let e=String(
t.fillStyle);if(e.startsWith("#")&&e!=="#010203")return e}}return i.frame<0?jt.still:Jo[i.frame%Jo.length]}function St(i,t="",e=""){let n=document.createElement(i);return t&&(n.textContent=t),e&&(n.className=e),n}var du=i=>i===null?"\u2013":typeof i=="number"&&!Number.isInteger(i)?He(i):String(i),ry={gTol:"gap of closed contacts [m]",inBodies:"joints within bodies",flat:"bodies kept in a plane",rowsSaved:"rows saved",of:"of all joints",every:"signals every [s]",until:"until [s]",step:"step [s]",framesPerSecond:"\
frames per second"},oy=(i,t)=>t===""||(i==="tolerance"||i==="step")&&t===0;function pu(i){let t=St("table"),e=(n,s)=>{for(let[r,o]of Object.entries(n)){let a=Array.isArray(o)?o:null;if(oy(r,o)||a&&a.some(u=>u!==null&&typeof u=="object"))continue;let l=t.insertRow(),c=l.insertCell();c.textContent=ry[r]??r.replace(/_/g," ").replace(/([a-z])([A-Z])/g,"$1 $2").toLowerCase(),c.style.paddingLeft=`${14*s}\
px`,o!==null&&typeof o=="object"&&!a?(c.colSpan=2,c.className="group",e(o,s+1)):l.insertCell().textContent=a?a.map(du).join(", "):du(o)}};return e(i,0),t}function mu(i){let t=Array.isArray(i.checks)?i.checks:[];if(!t.length)return null;let e=St("table","","checks");for(let n of t){let s=e.insertRow();s.insertCell().append(St("span",n.pass?"pass":"fail",n.pass?"good":"bad")),s.insertCell().textContent=
`${n.measure==="value"?"":`${n.measure} `}${n.signal}${n.over?` ${n.over}`:""}`,s.insertCell().textContent=`${du(n.got)} (${String(n.expected)})`}return e}function pp(i){let t=St("table");for(let[e,n]of up){let s=t.insertRow();s.insertCell().textContent=e,s.insertCell().textContent=n}i.append(St("h2","Keys"),t),i.onclick=()=>i.close()}var gu=i=>`${i.title??i.curves[0]?.name} [${i.unit}]`;function dp(i,t,e){
let{run:n}=i,s=[],r=(...u)=>{s.push(...s.length?[" \xB7 ",...u]:u)};n&&typeof n.state=="string"&&r(["finished","ok","done"].includes(n.state)?n.state:St("b",n.state,"bad"));let o=Array.isArray(n?.checks)?n.checks:[],a=Array.isArray(n?.warnings)?n.warnings.length:0,l=o.filter(u=>u.pass===!1).length;l&&r(St("b",`${l} of ${o.length} checks failed`,"bad")),a&&r(St("b",a===1?"1 warning":`${a} warnings`,
"bad")),r(St("b",He(t))," s");for(let[u,h]of[["steps","steps"],["impacts","impacts"],["switches","changes of status"]])n&&typeof n[u]=="number"&&r(St("b",String(n[u])),` ${h}`);n&&typeof n.wall_s=="number"&&r("computed in ",St("b",He(n.wall_s))," s");let{recorded:c}=i.frames;return e&&r(e<c?St("b",`${e} of ${c} frames`,"bad"):`${e} frames`),s}function mp(i,t,e,n,s){let r=dp(t,e,n);i.replaceChildren(
...s?[`${t.title}: `,...r,"  \u2016  ",`${s.title}: `,...dp(s.data,s.end-s.begin,s.film.count)]:r),i.title=i.textContent??""}function cl(i){let t=i.get("t");if(!t)return[];let e=u=>i.get(u)??new Float64Array(t.length),n=(u,h)=>({name:u,t,y:h}),s=(u,h)=>e(u).some(f=>f!==0)?[n(h,e(u))]:[],r=e("kinetic"),o=e("potential"),a=[];a.push({title:"energy",unit:"J",height:170,curves:[n("kinetic",r),n("potent\
ial",o),n("sum",r.map((u,h)=>u+o[h]))]});let l=[...s("normal","normal forces"),...s("friction","friction"),...s("nonPotential","drives, dampers"),...s("joints","joints"),...s("boundaries","moving boundaries")];l.length&&a.push({title:"work",unit:"J",height:160,curves:l}),a.push({title:"ledger",unit:"J",curves:s("discretisation","discretisation")});let c=(u,h,f,d=!1)=>{let g=s(u,h);g.length&&a.push(
{unit:f,curves:g,log:d,height:110})};return c("residual","solver residual","",!0),c("iterations","iterations",""),c("contacts","contacts",""),c("penetration","penetration","m",!0),a.filter(u=>u.curves.length)}var zr=26,al=["all","impacts","switches"],ll=class{constructor(t,e,n,s){this.box=t;this.all=e;this.leftOut=n;this.seek=s;this.rows=St("div","","rows");this.bar=St("div","","bar");this.note=St(
"p","","note");this.kind="all";this.events=[];this.brief=!1;this.current=-1;this.t=0;for(let o of al){let a=St("button");a.onclick=()=>{this.kind=o,this.grown()},this.bar.append(a)}let r=St("div","","listhead");r.append(this.bar,this.note),t.replaceChildren(r,this.rows),this.grown(),t.addEventListener("scroll",()=>this.fill())}take(t){this.all=t,this.grown()}isOf(t,e){return e==="all"||t.impact===
(e==="impacts")}listed(){return this.brief?this.all:this.all.filter(t=>!t.brief)}grown(){let t=this.listed();[...this.bar.children].forEach((e,n)=>{e.textContent=`${al[n]} ${t.filter(s=>this.isOf(s,al[n])).length}`,Ts(e,al[n]===this.kind)}),this.fillNote(),this.events=t.filter(e=>this.isOf(e,this.kind)),this.rows.style.height=`${zr*this.events.length}px`,this.current=-2,this.show(this.t,!0)}fillNote(){
let t=this.all.reduce((s,r)=>s+(r.other?0:1),0),e=this.all.reduce((s,r)=>s+(r.brief?1:0),0),n=[];if(e){let s=St("button",this.brief?"leave them out":"list them","inline");s.onclick=()=>{this.brief=!this.brief,this.grown()},n.push(`${e} switches are taken back within a step: `,s)}this.leftOut>0&&(n.length&&n.push(St("br")),n.push(St("b",`The run recorded the first ${t} of ${t+this.leftOut} events.`))),
this.note.replaceChildren(...n),this.note.hidden=!n.length}from(t,e,n){let s=this.events.length?this.events:this.listed();return e>0?s.find(r=>r.t>t+n):[...s].reverse().find(r=>r.t<t-n)}show(t,e=!1){this.t=t;let{events:n}=this,s=n.length&&n[0].t<=t?zi(n.map(r=>r.t),t):-1;if(!(s===this.current&&!e)){if(this.current=s,this.box.clientHeight){let r=Math.max(0,s)*zr,{scrollTop:o,clientHeight:a}=this.box;
(r<o||r>o+a-3*zr)&&(this.box.scrollTop=r-a/3)}this.fill()}}fill(){let t=Math.max(0,Math.floor(this.box.scrollTop/zr)-4),e=t+Math.ceil(this.box.clientHeight/zr)+8;this.rows.replaceChildren(...this.events.slice(t,e).map((n,s)=>{let r=St("div","",`event${t+s===this.current?" on":""}`);r.style.top=`${zr*(t+s)}px`;let o=St("i"),a=En.find(l=>l.name===(n.impact||n.system?"impact":n.to))??En[0];return o.style.
background=a.colour,r.append(o,St("span",`${n.t.toFixed(5)}`,"t"),St("span",n.run?`${n.run}: ${n.contact}`:n.contact,"c"),St("span",n.impact?`${He(n.speed)} m/s, ${He(n.impulse)} N s`:n.system?n.system:`${n.from} \u2192 ${n.to}`,"k")),r.title=n.impact?`impact on ${n.contact} at ${He(n.speed)} m/s with ${He(n.impulse)} N s`:n.contact,r.tabIndex=0,r.setAttribute("role","button"),r.onclick=()=>this.seek(
n.t),r.onkeydown=l=>{l.key==="Enter"&&(l.stopPropagation(),this.seek(n.t))},r}))}};function Ts(i,t){i?.classList.toggle("on",t),i?.setAttribute("aria-pressed",String(t))}function gp(i){let t=St("pre");for(let e of i.replace(/\n$/,"").split(`
`)){let n=St("code"),s=e.match(/<!--.*?(-->|$)|<\/?[\w.:-]+|"[^"]*"|\/?>|[^<>"]+|./g)??[];for(let r of s){let o=r.startsWith("<!--")?"note":/^<|^\/?>$/.test(r)?"tag":r.startsWith('"')?"value":"";n.append(o?St("span",r,o):r)}t.append(n)}return t}var ay=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],ly=[[.1,"soft"],[1,"medium"],[10,"hard"],[100,"very hard"]],hl=class{constructor(t){this.live=t;this.bar=St("div");this.pause=St("button","pause","text");this.step=St("button","one step","text");this.end=St("button","end the run","text");this.now=St("button","now","text");this.pace=St("select");this.phase=St("span");this.box=document.getElementById(
"live");this.said=St("p","","said");this.done=St("ol","","done");this.fields=new Map;this.bar.id="livebar",this.bar.setAttribute("role","group"),this.bar.setAttribute("aria-label","the run that is being computed"),this.phase.setAttribute("role","status");let{footer:e}={footer:document.querySelector("footer")},n=St("label","pace ");n.append(this.pace),this.bar.append(this.phase,this.pause,this.step,
this.now,n,this.end),e.prepend(this.bar),this.pause.title="pause or go on (space)",this.pause.onclick=()=>t.toggle(),this.step.title="one step, then pause",this.step.onclick=()=>{t.toEdge(),t.order("step")},this.now.title="show the present, not the past (end)",this.now.onclick=()=>t.toEdge(),this.end.title="end the run and write its files",this.end.onclick=()=>{t.order("end")},this.fillPace(t.state.
pace),this.pace.onchange=()=>{t.order("pace","",[Number(this.pace.value)])},this.fillPanel(t.state)}fillPace(t){let e=[...new Set([...ay,...t>0?[t]:[]])].sort((s,r)=>s-r),n=(s,r)=>{let o=St("option",s);return o.value=String(r),o.selected=r===t,o};this.pace.replaceChildren(...e.map(s=>n(s<1?`1/${Math.round(1/s)}`:s===1?"real time":`\xD7${s}`,s)),n("as fast as it can",0)),this.pace.title="simulated \
time over your time"}fillPanel(t){this.said.setAttribute("role","alert");let e=St("select"),n=St("label","strength of the hand ");for(let[s,r]of ly){let o=St("option",r);o.value=String(s),o.selected=s===1,e.append(o)}e.onchange=()=>{this.live.strength=Number(e.value)},n.append(e),this.box.append(this.said,St("p","Pull a body with the pointer. With shift the pointer moves the view.","none"),n);for(let[
s,r]of[["parameters","Parameters"],["inputs","Inputs"]]){let o=Object.keys(t[s]);if(!o.length)continue;let a=St("table");for(let l of o)a.append(this.row(s,l,t[s][l]));this.box.append(St("h2",r),a)}this.box.append(St("h2","What was done"),this.done)}row(t,e,n){let s=St("tr"),r=St("input");return r.type="text",r.inputMode="decimal",r.value=String(n),r.setAttribute("aria-label",e),r.onchange=()=>{let o=Number(
r.value.trim()||NaN);if(!Number.isFinite(o)){this.say(`${e}: ${r.value} is no number`);return}this.live.order(t==="parameters"?"set":"input",e,[o]).then(a=>{a||(r.value=String(this.live.state[t][e]))})},this.fields.set(`${t} ${e}`,r),s.insertCell().textContent=e,s.insertCell().append(r),s}show(t){let e={waiting:"the run waits",running:"computing",paused:"paused",ended:"the run has ended"};this.phase.
textContent=`${e[t.phase]} \xB7 ${He(t.t)} s`,this.phase.className=t.phase,this.pause.textContent=t.phase==="paused"?"go on":"pause",this.now.classList.toggle("on",this.live.atEdge);for(let n of["parameters","inputs"])for(let[s,r]of Object.entries(t[n])){let o=this.fields.get(`${n} ${s}`);o&&o!==document.activeElement&&(o.value=String(r))}}say(t){this.said.textContent=t}note(t,e,n,s){if(e==="move")
return;let r={set:`${n} = ${s[0]}`,input:`${n} = ${s[0]}`,grab:"pull a body",release:"let go",end:"end the run"},o=St("li",r[e]??e);o.prepend(St("span",`${He(t)} s`)),this.done.append(o),o.scrollIntoView({block:"nearest"})}close(){this.bar.hidden=!0;for(let t of this.box.querySelectorAll("input, select"))t.disabled=!0}};var cy=4e4,ul=class{constructor(t,e){this.signals=e;this.events=[];this.ledger=new Map;this.state=null;this.time=new kr(t=>new Float64Array(t));this.at={signals:0,events:0,ledger:0,frames:0};this.frames=new ol;this.lines={signals:new Br,events:new Br,ledger:new Br};this.film=new rl(t),this.values=e.map(()=>new kr(n=>new Float32Array(n)))}async ask(){let t=Object.keys(this.at).map(l=>`${l}=${this.at[l]}`).
join("&"),e=await fetch(`feed?number=${this.state?.number??0}&${t}`,{cache:"no-store"});if(!e.ok)throw new Error(await e.text());let n=new Uint8Array(await e.arrayBuffer()),s=4+new DataView(n.buffer).getUint32(0,!0),r=JSON.parse(new TextDecoder().decode(n.subarray(4,s))),o=s,a=!1;for(let l of Object.keys(this.at)){let c=n.subarray(o,o+=r[l]);this.at[l]+=c.length,a||=c.length>0,this.take(l,c)}return this.
state=r,a}take(t,e){if(t==="frames"){this.film.append(this.frames.take(e));return}let n=this.lines[t].take(e);t==="events"&&this.events.push(...n.map(ap)),t==="signals"&&this.takeRows(n),t==="ledger"&&this.takeLedger(n,this.lines.ledger.head.split(","))}takeRows(t){for(let e of t){let n=e.split(",").map(Number);this.time.push(n[0]),this.values.forEach((s,r)=>s.push(n[r+1]))}if(this.time.length>cy)
for(let e of[this.time,...this.values])e.thin();this.signals.forEach((e,n)=>{e.t=this.time.view,e.y=this.values[n].view})}takeLedger(t,e){for(let n of t)n.split(",").forEach((s,r)=>{let o=this.ledger.get(e[r]);o||this.ledger.set(e[r],o=new kr(a=>new Float64Array(a))),o.push(Number(s))})}ledgerColumns(){return new Map([...this.ledger].map(([t,e])=>[t,e.view]))}},fl=class{constructor(t,e){this.replay=
t;this.feed=e;this.atEdge=!0;this.strength=1;this.held=null;this.sending=!1;this.fresh=0;this.panel=new hl(this),this.show(!0),this.follow()}get state(){return this.feed.state}get goes(){return this.state.phase!=="ended"}async follow(){try{for(;this.goes;){let e=await this.feed.ask();this.show(e)}for(;await this.feed.ask();)this.show(!0);let t=await(await fetch("facts",{cache:"no-store"})).json();
this.replay.ended(t),await fetch("bye",{method:"POST"})}catch(t){this.panel.say(`The program no longer answers: ${t instanceof Error?t.message:t}`),this.state.phase="ended"}this.show(!0),this.panel.close()}show(t){let e=performance.now(),n=e-this.fresh>250||!this.goes;t&&this.replay.grow(this.feed,n),t&&n&&(this.fresh=e),this.panel.show(this.state),this.atEdge&&t&&this.replay.seek(this.replay.end)}async order(t,e="",n=[]){
try{let s=await fetch("do",{method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify({do:t,name:e,values:n})}),{error:r}=await s.json();return this.panel.say(r),!r&&!["pause","go","step","pace"].includes(t)&&this.panel.note(this.replay.end,t,e,n),!r}catch{return this.panel.say("The program no longer answers."),!1}}toggle(){this.toEdge(),this.order(this.state.phase==="paused"?"\
go":"pause")}toEdge(){this.atEdge=!0,this.replay.pause(!1).seek(this.replay.end)}async grab(t){if(!this.goes)return;this.toEdge();let e={...t,target:t.point,sent:t.point};this.held=e;let{r:n,q:s}=this.replay.film.pose(t.frame,this.replay.t);if(e.local=je([s[0],-s[1],-s[2],-s[3]],Zt(t.point,n)),!await this.order("grab","",[t.frame,...e.local,...t.point,this.strength])){this.held===e&&(this.held=null);
return}this.held!==e?this.order("release"):this.pull()}move(t){this.held&&(this.held.target=t,this.sending||this.pull())}async pull(){let{held:t}=this;!t||this.sending||t.target===t.sent||!t.local||(this.sending=!0,t.sent=t.target,await this.order("move","",t.target),await new Promise(e=>setTimeout(e,20)),this.sending=!1,this.held===t&&t.target!==t.sent&&this.pull())}release(){this.held&&(this.held=
null,this.order("release"))}get line(){let{held:t}=this;if(!t?.local)return null;let{r:e,q:n}=this.replay.film.pose(t.frame,this.replay.t);return[_t(e,je(n,t.local)),t.target]}pointAt(t,e,n){let{camera:s}=this.replay.stage,r=s.scaleAt(n)||s.scale,o=It(Zt(n,s.centre),s.toward);return _t(s.centre,_t(yt(s.toward,o),_t(yt(s.right,(t-s.width/2)/r),yt(s.up,(s.height/2-e)/r))))}};function pl(i,t,e){if(t.isPlanar)return ml(i);let n=Kn([-.45,.65,.62]),s=[It(e,t.right),It(e,t.up),It(e,t.toward)];return Ye(i,-.22+.6*Math.max(0,It(s,n)))}var ml=i=>Ye(i,jt.dark?-.12:.3),gl=i=>Ye(i,jt.dark?.3:-.38);function $e(i,t=!0){let e=new Path2D;return i.forEach((n,s)=>s?e.lineTo(n[0],n[1]):e.moveTo(n[0],n[1])),t&&e.closePath(),e}function yp(i){let t=i.slice().sort((n,s)=>n[0]-s[0]||n[1]-s[1]),
e=n=>{let s=[];for(let r of n){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return e(t).concat(e(t.reverse()))}function Vr(i,t,e,n){i.fillStyle=e,i.fill(t),i.strokeStyle=gl(n),i.lineWidth=1.3,i.lineJoin="round",i.stroke(t)}function vl(i,t,e,n,s=40){return Array.from({length:s},(r,o)=>{let a=2*Math.PI*o/s;return _t(
i,_t(yt(t,n*Math.cos(a)),yt(e,n*Math.sin(a))))})}var yl=[[1,0,0],[0,1,0],[0,0,1]];function hy(i,t){let e=t.r,n=i.radius??0;return{centre:e,planes:[],least:s=>It(s,e)-n,points:()=>yu(e,[[n,0,0],[0,n,0],[0,0,n]]),paint(s,r,o){let[a,l]=r.project(e),c=Math.max(1.5,n*r.scale),u=new Path2D;u.arc(a,l,c,0,2*Math.PI);let h=ml(o);return r.isPlanar||(h=s.createRadialGradient(a-.35*c,l-.42*c,.05*c,a,l,c),h.addColorStop(
0,Ye(o,.62)),h.addColorStop(.55,Ye(o,.12)),h.addColorStop(1,Ye(o,-.25))),Vr(s,u,h,o),c>6&&xy(s,r,t,n,o),u}}}function uy(i,t){let e=i.halfExtents??[0,0,0],n=yl.map(o=>je(t.q,o)),s=n.map((o,a)=>yt(o,e[a])),r=[];for(let o of[0,1,2])for(let a of[1,-1]){let l=yt(n[o],a);r.push({n:l,o:It(l,t.r)+e[o],k:o,s:a})}return{centre:t.r,planes:r,least:o=>It(o,t.r)-s.reduce((a,l)=>a+Math.abs(It(o,l)),0),points:()=>yu(
t.r,s),paint(o,a,l){let c=new Path2D;for(let{n:u,k:h,s:f}of r){if(It(u,a.toward)<=.001)continue;let[d,g]=[s[(h+1)%3],s[(h+2)%3]],v=_t(t.r,yt(s[h],f)),m=[[1,1],[-1,1],[-1,-1],[1,-1]].map(([b,T])=>a.project(_t(v,_t(yt(d,b),yt(g,T))))),p=$e(m);Vr(o,p,pl(l,a,u),l),c.addPath(p)}return c}}}function fy(i,t){let e=je(t.q,[0,0,i.halfLength??0]),n=i.radius??0,s=[Zt(t.r,e),_t(t.r,e)];return{centre:t.r,planes:[],
least:r=>It(r,t.r)-Math.abs(It(r,e))-n,points:()=>s.flatMap(r=>yu(r,[[n,0,0],[0,n,0],[0,0,n]])),paint(r,o,a){let l=n*o.scale,[c,u]=s.map(d=>o.project(d)),h=Math.atan2(u[1]-c[1],u[0]-c[0]),f=new Path2D;return f.arc(c[0],c[1],l,h+Math.PI/2,h-Math.PI/2),f.arc(u[0],u[1],l,h-Math.PI/2,h+Math.PI/2),f.closePath(),Vr(r,f,bp(r,o,c,h,l,a),a),f}}}function dy(i,t){let[e,n,s]=yl.map(u=>je(t.q,u)),r=i.radius??0,
o=i.halfLength??0,a=yt(s,o),l=[Zt(t.r,a),_t(t.r,a)],c=l.map(u=>vl(u,e,n,r));return{centre:t.r,planes:[1,-1].map(u=>({n:yt(s,u),o:u*It(s,t.r)+o})),least:u=>It(u,t.r)-Math.abs(It(u,a))-r*Math.hypot(It(u,e),It(u,n)),points:()=>c.flat(),paint(u,h,f){let d=c.map(T=>T.map(_=>h.project(_))),g=$e(yp(d.flat())),[v,m]=l.map(T=>h.project(T)),p=Math.atan2(m[1]-v[1],m[0]-v[0]);Vr(u,g,bp(u,h,v,p,r*h.scale,f),f);
let b=It(s,h.toward);if(Math.abs(b)>.001){let T=b>0?1:0;Vr(u,$e(d[T]),pl(f,h,yt(s,Math.sign(b))),f),Mp(u,h,l[T],e,r,f)}return g}}}function xp(i,t,e){return{centre:e,planes:[],least:n=>Math.min(...i.map(s=>It(n,s))),points:()=>i,paint(n,s,r){let o=new Path2D,a=[];for(let l of t){let c=l.map(h=>i[h]),u=Kn(rn(Zt(c[1],c[0]),Zt(c[2],c[0])));It(u,s.toward)>.001&&a.push({n:u,corners:c,depth:It(dl(c),s.toward)})}
a.sort((l,c)=>l.depth-c.depth);for(let{n:l,corners:c}of a){let u=$e(c.map(h=>s.project(h)));n.fillStyle=n.strokeStyle=pl(r,s,l),n.lineWidth=.7,n.fill(u),n.stroke(u),o.addPath(u)}return o}}}function vu(i,t,e,n){let s=[],r=[];for(let o=0;o<=t;++o)for(let a=0;a<e;++a)s.push(_t(i.r,je(i.q,n(o/t,2*Math.PI*a/e))));for(let o=0;o<t;++o)for(let a=0;a<e;++a){let[l,c]=[o*e+a,o*e+(a+1)%e];r.push([l,c,c+e],[l,
c+e,l+e])}return xp(s,r,i.r)}function py(i,t){let[e,n,s]=i.halfExtents??[0,0,0];return vu(t,14,28,(r,o)=>{let a=Math.sin(Math.PI*r);return[e*a*Math.cos(o),n*a*Math.sin(o),-s*Math.cos(Math.PI*r)]})}function my(i,t){let e=i.radius??0,n=i.tube??0;return vu(t,14,40,(s,r)=>{let o=e-n*Math.cos(2*Math.PI*s);return[o*Math.cos(r),o*Math.sin(r),-n*Math.sin(2*Math.PI*s)]})}function gy(i,t){let e=i.radius??0,
n=2*(i.halfLength??0);return vu(t,2,40,(s,r)=>{let o=s===.5?e:0;return[o*Math.cos(r),o*Math.sin(r),s===1?n:0]})}function vy(i,t){let[e,n,s]=yl.map(l=>je(t.q,l)),r=i.radius??0,o=_p(vl(t.r,e,n,r,64),t.r,s),a=o.paint;return o.paint=(l,c,u)=>{let h=a(l,c,u);return Mp(l,c,t.r,e,r,u),h},o}var dl=i=>yt(i.reduce(_t,[0,0,0]),1/(i.length||1)),As={sphere:hy,box:uy,capsule:fy,cylinder:dy,circle:vy,ellipsoid:py,
torus:my,cone:gy,mesh(i,t){let e=(i.points??[]).map(n=>_t(t.r,je(t.q,n)));return xp(e,i.triangles??[],dl(e))},polygon(i,t){let e=(i.points??[]).map(s=>_t(t.r,je(t.q,s))),n=e.length>2?Kn(rn(Zt(e[1],e[0]),Zt(e[2],e[0]))):[0,0,1];return _p(e,dl(e),n)},segment:(i,t)=>vp((i.points??[]).map(e=>_t(t.r,je(t.q,e))),i),link(i,t,e){let[n,s]=i.points??[];return vp([_t(t.r,je(t.q,n??[0,0,0])),_t(e.r,je(e.q,s??
[0,0,0]))],i)}};function yu(i,[t,e,n]){let s=[];for(let r of[-1,1])for(let o of[-1,1])for(let a of[-1,1])s.push(_t(i,_t(yt(t,r),_t(yt(e,o),yt(n,a)))));return s}function _p(i,t,e){let n=It(e,t);return{centre:t,points:()=>i,planes:[{n:e,o:n},{n:yt(e,-1),o:-n}],least:s=>Math.min(...i.map(r=>It(s,r))),paint(s,r,o){let a=$e(i.map(l=>r.project(l)));return Vr(s,a,pl(o,r,It(e,r.toward)<0?yt(e,-1):e),o),a}}}
function vp(i,t){return{centre:dl(i),points:()=>i,planes:[],least:e=>Math.min(...i.map(n=>It(e,n))),paint(e,n,s){let r=i.map(c=>n.project(c)),o=t.radius??0,a=o>0?Math.max(1.5,2*o*n.scale):2.4;t.style==="spring"&&(r=yy(r[0],r[r.length-1],8));let l=$e(r,!1);return e.lineCap=e.lineJoin="round",e.setLineDash(t.style==="dashed"?[7,6]:[]),o>0&&t.style!=="spring"?(e.strokeStyle=gl(s),e.lineWidth=a+2.6,e.
stroke(l),e.strokeStyle=ml(s)):e.strokeStyle=Ye(s,jt.dark?.25:-.2),e.lineWidth=t.style==="spring"?1.8:a,e.stroke(l),e.setLineDash([]),$e(yp(r.flatMap(([c,u])=>[[c-4,u-4],[c+4,u-4],[c,u+5]])))}}}function yy(i,t,e){let n=[t[0]-i[0],t[1]-i[1]],s=Math.hypot(...n)||1,r=[-n[1]/s*e,n[0]/s*e],o=(l,c)=>[i[0]+n[0]*l+r[0]*c,i[1]+n[1]*l+r[1]*c],a=Array.from({length:24},(l,c)=>o(.1+.8*(c+.5)/24,c%2?1:-1));return[
i,o(.1,0),...a,o(.9,0),t]}function bp(i,t,e,n,s,r){if(t.isPlanar)return ml(r);let o=[Math.sin(n),-Math.cos(n)];o[0]*-.45+o[1]*-.65<0&&(o=[-o[0],-o[1]]);let a=i.createLinearGradient(e[0]+o[0]*s,e[1]+o[1]*s,e[0]-o[0]*s,e[1]-o[1]*s);return a.addColorStop(0,Ye(r,.25)),a.addColorStop(.3,Ye(r,.5)),a.addColorStop(1,Ye(r,-.25)),a}function Mp(i,t,e,n,s,r){let o=t.project(e),a=t.project(_t(e,yt(n,s)));i.strokeStyle=
i.fillStyle=gl(r),i.lineWidth=1.3,i.stroke($e([o,a],!1)),i.beginPath(),i.arc(o[0],o[1],2.2,0,2*Math.PI),i.fill()}function xy(i,t,e,n,s){i.strokeStyle=gl(s)+(t.isPlanar?"b0":"70"),i.lineWidth=1.1;let[r,o,a]=yl.map(l=>je(e.q,l));for(let[l,c]of[[o,a],[r,o]]){let u=rn(l,c),h=rn(u,t.toward);if(xn(h)<1e-6)continue;h=Kn(h);let f=rn(h,u);It(f,t.toward)<0&&(f=yt(f,-1));let d=Array.from({length:25},(g,v)=>{
let m=Math.PI*v/24;return t.project(_t(e.r,_t(yt(h,n*Math.cos(m)),yt(f,n*Math.sin(m)))))});i.stroke($e(d,!1))}}function _y(i,t,e){for(let{c:n,n:s}of t){let r=[];i.forEach((o,a)=>{let l=i[(a+1)%i.length],c=It(s,Zt(o,n))+e,u=It(s,Zt(l,n))+e;c>=0&&r.push(o),c*u<0&&r.push(_t(o,yt(Zt(l,o),c/(c-u))))}),i=r}return i}function xu(i,t,e,n){for(let{c:s,n:r}of e){let o=It(r,Zt(i,s))+n,a=It(r,Zt(t,s))+n;if(o<0&&a<0)return null;if(o*a>=0)continue;let l=_t(i,yt(Zt(t,i),o/(o-a)));o<0?i=l:t=l}return[i,t]}function _u({c:i,n:t},e,n,s,r){
let o=Qa(t),a=rn(t,o),l=Zt(e,yt(t,It(t,Zt(e,i)))),{step:c}=ji(0,2*n,s),u=Math.ceil(n/c),h=1e-6*n,f=[o,a].map(v=>Math.round(It(l,v)/c)*c-It(l,v)),d=(v,m)=>_t(l,_t(yt(o,f[0]+v*c),yt(a,f[1]+m*c))),g=[];for(let v=-u;v<=u;++v)for(let[m,p]of[[d(v,-u),d(v,u)],[d(-u,v),d(u,v)]]){let b=xu(m,p,r,h);b&&g.push(b)}return{outline:_y([d(-u,-u),d(u,-u),d(u,u),d(-u,u)],r,h),lines:g}}var Cs=class{constructor(t,e){this.scene=t;this.film=e;this.bodies=t.shapes.filter(r=>r.kind in As&&r.colour!=="transparent");let n=t.shapes.filter(r=>r.kind==="halfspace");this.grounds=n.filter(r=>r.colour!=="transparent"),this.extent=this.measure();let s=n.length?this.plane(n[0],e.begin).n:[0,0,1];this.upAxis=Math.abs(s[1])>.9?1:2}remeasure(){let t=this.extent.size,e=this.measure();return e.size<
1.1*t?!1:(this.extent=e,!0)}shapePose(t,e){return tl(this.film.pose(t.frame,e),t.position,t.orientation)}plane(t,e){let n=this.shapePose(t,e);return{c:n.r,n:je(n.q,[0,0,1])}}absent(t,e){return this.film.absent(t.frame,e)||this.film.absent(t.frameEnd??-1,e)}endsOf(t,e){let n=this.bodies.filter(s=>s.frame>=0&&s.frame!==t.frame&&!this.absent(s,e)).slice(0,300).map(s=>this.shapePose(s,e).r);return this.
grounds.filter(s=>s!==t).map(s=>this.plane(s,e)).filter(({c:s,n:r})=>n.every(o=>It(r,Zt(o,s))>=0))}sheet(t,e,n,s){let{lo:r,hi:o,size:a}=this.extent;return _u(this.plane(t,e),yt(_t(r,o),.5),n*a,s,this.endsOf(t,e))}sheetAround(t,e,n,s,r){return _u(this.plane(t,e),n,s,r,this.endsOf(t,e))}pointsOf(t,e){if(this.absent(t,e))return[];let n=this.shapePose(t,e),s=t.radius??0;return t.kind==="sphere"&&this.
bodies.length>300?[_t(n.r,[s,s,s]),Zt(n.r,[s,s,s])]:As[t.kind](t,n,this.film.pose(t.frameEnd??-1,e)).points()}instants(t,e){let n=wn(Math.floor(3e3/Math.max(1,t)),2,e),{begin:s,end:r}=this.film;return Array.from({length:n},(o,a)=>s+(r-s)*a/(n-1))}measure(){let t=[1/0,1/0,1/0],e=[-1/0,-1/0,-1/0],n=[],s=o=>{o.every(Number.isFinite)&&(n.push(o),o.forEach((a,l)=>{t[l]=Math.min(t[l],a),e[l]=Math.max(e[l],
a)}))};for(let o of this.instants(this.bodies.length,60))for(let a of this.bodies)this.pointsOf(a,o).forEach(s);t[0]<=e[0]||(s([-1,-1,-1]),s([1,1,1]));let r=Math.max(xn(Zt(e,t)),1e-9);if(n.length>2e4){n=[];for(let o of[t[0],e[0]])for(let a of[t[1],e[1]])for(let l of[t[2],e[2]])n.push([o,a,l])}for(let o of this.grounds){let{c:a,n:l}=this.plane(o,this.film.begin),c=yt(_t(t,e),.5),u=Zt(c,yt(l,It(l,Zt(
c,a))));xn(Zt(u,c))<1.5*r&&s(u)}return{lo:t,hi:e,points:n,size:Math.max(xn(Zt(e,t)),1e-9)}}pointsAround(t,e){let n=this.bodies.filter(r=>this.film.moves(r.frame)),s=[];for(let r of this.instants(n.length,40)){let o=Zt(e,this.film.pose(t,r).r);for(let a of n)for(let l of this.pointsOf(a,r))l.every(Number.isFinite)&&s.push(_t(l,o))}return s.length?s:this.extent.points}naturalView(){if(this.scene.view)
return this.scene.view;let{film:t}=this,e=(n,s)=>{for(let r=0;r<t.poses;++r)if(!t.stands(r,n)||s.some(o=>!t.stands(r,3+o,0)))return!1;return t.poses>0};return this.upAxis===1&&e(2,[1,2])?"xy":e(1,[1,3])?"xz":e(2,[1,2])?"xy":e(0,[2,3])?"yz":"iso"}};function Sp(i){let t=e=>{let n=1/0,s=-1/0;for(let r of i)n=Math.min(n,r[e]),s=Math.max(s,r[e]);return s-n};return Math.max(xn([t(0),t(1),t(2)]),1e-9)}var by=500,Hr=class i{constructor(t,e,n,s,r,o,a){this.title=t;this.data=e;this.scene=n;this.film=s;this.signals=r;this.events=o;this.ledger=a;this.spanned=null;let l=n.shapes.filter(c=>c.kind in As&&c.colour!=="transparent"&&c.frame>=0);this.bodies=l.slice(0,by),this.leftOut=l.length-this.bodies.length}get begin(){return Ss(this.film,this.signals)[0]}get end(){return Ss(this.film,this.signals)[1]}get points(){
return this.spanned??=new Cs(this.scene,this.film).extent.points,this.spanned}frameNamed(t){return t===void 0?-1:this.scene.frames.findIndex(e=>e.name===t)}static async fromPage(t,e){let n=new DOMParser().parseFromString(t,"text/html").getElementById("data")?.textContent;if(!n)throw new Error("it holds no run");return i.from(JSON.parse(n),e)}static async from(t,e){let[n,s,r,o,a]=await Promise.all(
[el(t),Or.from(t.frames),nl(t),il(t),sl(t)]);return new i(t.title||e,t,n,s,r,o,a)}paint(t,e,n){t.save(),t.globalAlpha=.4;let r=this.bodies.filter(o=>!this.film.absent(o.frame,n)&&!this.film.absent(o.frameEnd??-1,n)).map(o=>({shape:o,item:As[o.kind](o,tl(this.film.pose(o.frame,n),o.position,o.orientation),this.film.pose(o.frameEnd??-1,n))}));r.sort((o,a)=>e.depth(o.item.centre)-e.depth(a.item.centre));
for(let{shape:o,item:a}of r){let l=a.paint(t,e,Ye(Es(o),jt.dark?-.3:.4));t.setLineDash([5,4]),t.strokeStyle=jt.ink,t.lineWidth=1.5,t.stroke(l),t.setLineDash([])}t.restore()}addTo(t,e){return this.merged(t.map(n=>({panel:n,theirs:this.signals})),e)}addLedger(t,e){let n=cl(this.ledger),s=(o,a)=>gu(o)===gu(a),r=n.filter(o=>!t.some(a=>s(o,a)));return this.merged([...t.map(o=>({panel:o,theirs:n.find(a=>s(
a,o))?.curves??[]})),...r.map(o=>({panel:{...o,curves:[]},theirs:o.curves}))],e,!0)}merged(t,e,n=!1){let s=(r,o)=>o?`${r} (${o})`:r;return t.map(({panel:r,theirs:o})=>{let a=n?o.filter(u=>!r.curves.some(h=>h.name===u.name)):[],l=[...r.curves,...a].flatMap((u,h)=>{let f=o.find(d=>d.name===u.name);return f?[{name:s(u.name,this.title),t:f.t,y:f.y,dashed:!0,colour:r.curves.length+h}]:[]}),c=l.length>0?
r.curves.map(u=>({...u,name:s(u.name,e)})):r.curves;return{...r,curves:[...c,...l]}})}};function wp(i){let{camera:t}=i.stage,e=new URLSearchParams;e.set("t",String(Number(i.t.toPrecision(9)))),e.set("view",t.view),i.comparison.isBeside&&e.set("beside","1"),t.isPlanar||(e.set("azimuth",String(Math.round(t.azimuth*180/Math.PI))),e.set("elevation",String(Math.round(t.elevation*180/Math.PI)))),i.stage.forceFactor!==1&&e.set("arrows",String(Number(i.stage.forceFactor.toPrecision(3))));for(let[
n,s]of[["names",i.tools.labelled],["hide",i.tools.unseen]])s.length&&e.set(n,s.join(","));history.replaceState(null,"",`#${e}`),navigator.clipboard?.writeText(location.href).catch(()=>{})}function bu(i,t){let{camera:e}=i.stage;for(let o of["azimuth","elevation"])t.has(o)&&(e[o]=Number(t.get(o))*Math.PI/180);t.has("view")?i.setView(t.get("view")??""):(t.has("azimuth")||t.has("elevation"))&&(e.look(),
i.stage.fit());for(let o of["contacts","trails"])t.has(o)&&i.setSwitch(o,t.get(o)!=="0");let n=Number(t.get("arrows"));n>0&&Number.isFinite(n)&&(i.stage.forceFactor=n),i.tools.choose(t.get("names"),t.get("hide")),t.has("theme")&&i.setTheme(t.get("theme")==="dark");let s=t.get("open");s&&i.showTab(s);let r=Number(t.get("t"));i.pause().seek(t.has("t")&&Number.isFinite(r)?r:i.t),t.has("select")&&i.select(
Number(t.get("select"))),t.get("play")==="1"&&i.play()}var Mu=8;function Ep(i,t,e){if(i.absent(t,e))return[];let n=i.pose(t,e),{v:s,omega:r}=i.rates(t,e),o=2*Math.acos(wn(Math.abs(n.q[0]),0,1))*180/Math.PI;return[["x",n.r[0]," m"],["y",n.r[1]," m"],["z",n.r[2]," m"],["speed",xn(s)," m/s"],["turned by",o,"\xB0"],["turns with",xn(r)," rad/s"]]}var Tp=(i,t)=>i.t.length?i.y[zi(i.t,t)]:NaN;function Ap(i,t,e,n,s,r,o){let{name:a}=t.frames[s],l=`${a.split(".")[0]}\
.`,c=o?.frameNamed(a)??-1,u=o&&c>=0?Ep(o.film,c,r):[],h=Ep(e,s,r).map(([d,g,v],m)=>[d,`${He(g)}${v}`,...u[m]?[`${He(u[m][1])}${v}`]:[]]);e.absent(s,r)&&h.push(["","absent"]);let f=n.filter(d=>d.name.startsWith(l)&&!/\.[xyz]$/.test(d.name));for(let d of f.slice(0,Mu)){let g=c>=0?o?.signals.find(v=>v.name===d.name):void 0;h.push([d.name.slice(l.length),`${He(Tp(d,r))} ${d.unit}`,...c>=0?[g?`${He(Tp(
g,r))} ${g.unit}`:"\u2013"]:[]])}f.length>Mu&&h.push(["",`and ${f.length-Mu} more signals`]),c>=0&&o&&h.unshift(["","this run",o.title]),i.replaceChildren(...h.map(d=>{let g=St("tr");return g.append(...d.map(v=>St("td",v))),g}))}var xl=class{constructor(t){this.film=t;this.on=!1;this.marks=[]}take(t,e,n){this.marks.length===2&&(this.marks=[]);let{r:s,q:r}=this.film.pose(t,n);this.marks.push({frame:t,local:je([r[0],-r[1],-r[2],-r[3]],Zt(e,s))})}clear(){this.marks=[]}points(t){return this.marks.map(({frame:e,local:n})=>{let{r:s,q:r}=this.film.pose(e,t);return _t(s,je(r,n))})}text(t){let[e,n]=this.points(t);if(!e)return"clic\
k two points";if(!n)return"click the second point";let s=Zt(n,e);return`${He(xn(s))} m   ${["x","y","z"].map((r,o)=>`\u0394${r} ${He(s[o])}`).join("   ")}`}};var _l=class{constructor(t,e,n){this.stage=t;this.scene=e;this.redraw=n;this.other=null;this.hidden=new Set;this.named=new Set;this.onNames=()=>{};this.unknown=[];this.said=St("p","","measured");this.file=St("input");this.all=St("button","show all");this.measure=new xl(t.model.film),t.overlay.measure=this.measure;let s=document.getElementById("stage");this.said.setAttribute("role","status"),this.said.
hidden=!0,this.all.hidden=!0,this.all.title="show the bodies that are hidden (shift h)",this.all.onclick=()=>this.showAll(),this.file.type="file",this.file.accept=".html",this.file.hidden=!0,this.file.setAttribute("aria-label","replay.html of another run"),s.append(this.said,this.file),document.getElementById("switches").append(this.all)}buttons(t){let e=St("p","","acts"),n=(s,r,o)=>{let a=St("but\
ton",s);a.title=r,a.onclick=o,e.append(a)};return n("hide","do not show this body (h)",()=>this.hide(t)),n("others","show this body alone, or all again",()=>this.hideOthers(t)),n("name","write its name into the picture",()=>this.name(t)),e}get names(){return this.scene.frames.map(t=>t.name)}get labelled(){return this.namesOf(this.named)}get unseen(){return this.namesOf(this.hidden)}namesOf(t){return[
...t].map(e=>this.scene.frames[e].name)}framesIn(t){let e=t.split(",").map(s=>s.trim()).filter(s=>s),n=e.map(s=>this.names.indexOf(s));return this.unknown.push(...e.filter((s,r)=>n[r]<0)),n.filter(s=>s>=0)}choose(t,e){this.unknown=[],t!==null&&(this.named=new Set(t==="1"?this.nameable():t==="0"?[]:this.framesIn(t))),e!==null&&(this.hidden.clear(),this.framesIn(e).forEach(n=>this.hidden.add(n))),(t!==
null||e!==null)&&this.apply()}hide(t){t<0||(this.hidden.add(t),this.apply())}hideOthers(t){let e=this.scene.frames.map((n,s)=>s).filter(n=>n!==t);if(e.every(n=>this.hidden.has(n))){this.showAll();return}this.hidden.clear(),e.forEach(n=>this.hidden.add(n)),this.apply()}showAll(){this.hidden.clear(),this.apply()}name(t){this.named.delete(t)||this.named.add(t),this.apply()}nameAll(){this.named=new Set(
this.named.size?[]:this.nameable()),this.apply()}nameable(){return this.scene.frames.map((t,e)=>e).filter(t=>this.stage.model.bodies.some(e=>e.frame===t)).slice(0,100)}apply(){this.stage.hide(new Set(this.hidden)),this.stage.overlay.labels=[...this.named].filter(t=>!this.hidden.has(t)).map(t=>({frame:t,text:this.scene.frames[t].name})),this.all.hidden=!this.hidden.size,this.onNames(this.named.size>
0),this.redraw()}toggleMeasure(){return this.measure.on=!this.measure.on,this.measure.clear(),this.said.hidden=!this.measure.on,this.redraw(),this.measure.on}clicked(t,e,n){if(!this.measure.on)return!1;let s=this.stage.hitAt(t,e);return this.measure.take(s?.frame??-1,s?.point??this.stage.camera.unproject(t,e),n),this.redraw(),!0}show(t){this.measure.on&&(this.said.textContent=this.measure.text(t))}askForOther(t,e){
let{file:n}=this;n.onchange=async()=>{let s=n.files?.[0];if(n.onchange=null,!!s){try{t(await Hr.fromPage(await s.text(),s.name))}catch(r){e(`${s.name} is no replay of dynamY: ${r instanceof Error?r.message:r}`)}n.value=""}},n.click()}};var Cp={xy:{right:[1,0,0],up:[0,1,0],toward:[0,0,1]},xz:{right:[1,0,0],up:[0,0,1],toward:[0,-1,0]},yz:{right:[0,1,0],up:[0,0,1],toward:[1,0,0]}},Su=26*Math.PI/180,bl=class{constructor(){this.view="iso";this.upAxis=2;this.azimuth=-62*Math.PI/180;this.elevation=22*Math.PI/180;this.centre=[0,0,0];this.scale=100;this.width=1;this.height=1;this.perspective=!0;this.right=[1,0,0];this.up=[0,0,1];this.toward=
[0,-1,0];this.look()}get isPlanar(){return this.view in Cp}get distance(){return this.height/(2*Math.tan(Su/2)*this.scale)}get hasDepth(){return this.perspective&&!this.isPlanar}look(){if(this.isPlanar){Object.assign(this,Cp[this.view]);return}let[t,e]=[Math.cos(this.azimuth),Math.sin(this.azimuth)],[n,s]=[Math.cos(this.elevation),Math.sin(this.elevation)],r=o=>this.upAxis===2?o:this.upAxis===1?[o[1],
o[2],o[0]]:[o[2],o[0],o[1]];this.toward=r([n*t,n*e,s]),this.right=r([-e,t,0]),this.up=rn(this.toward,this.right)}scaleAt(t){if(!this.hasDepth)return this.scale;let e=this.distance,n=e-It(Zt(t,this.centre),this.toward);return n>.001*e?this.scale*e/n:0}project(t){let e=Zt(t,this.centre),n=this.scaleAt(t);return n===0?[-1e6,-1e6]:[this.width/2+n*It(e,this.right),this.height/2-n*It(e,this.up)]}unproject(t,e){
return _t(this.centre,_t(yt(this.right,(t-this.width/2)/this.scale),yt(this.up,(this.height/2-e)/this.scale)))}depth(t){return It(Zt(t,this.centre),this.toward)}orbit(t,e){this.azimuth-=t*.008,this.elevation=wn(this.elevation+e*.008,-1.55,1.55),this.look()}pan(t,e){this.centre=_t(this.centre,_t(yt(this.right,-t/this.scale),yt(this.up,e/this.scale)))}zoom(t,e,n){let s=this.unproject(e,n);this.scale*=
t,this.centre=_t(this.centre,Zt(s,this.unproject(e,n)))}fit(t){let e=d=>{let g=1/0,v=-1/0;for(let m of d)g=Math.min(g,m),v=Math.max(v,m);return[g,v]},n=d=>e(t.map(g=>It(g,d))),[s,r,o]=[n(this.right),n(this.up),n(this.toward)],a=Math.max(s[1]-s[0],r[1]-r[0],1e-9),l=56,c=this.height>420?92:44,u=this.width*.84,h=Math.max(40,this.height-l-c),f=d=>(d[0]+d[1])/2;this.scale=Math.min(u/Math.max(s[1]-s[0],
a*.001),h/Math.max(r[1]-r[0],a*.001)),this.centre=_t(yt(this.right,f(s)),_t(yt(this.up,f(r)),yt(this.toward,f(o))));for(let d=0;d<4;++d){let g=t.map(p=>this.project(p)),v=e(g.map(p=>p[0])),m=e(g.map(p=>p[1]));if(this.centre=this.unproject(f(v),f(m)-(l-c)/2),!this.hasDepth)break;this.scale*=Math.min(u/Math.max(v[1]-v[0],.001),h/Math.max(m[1]-m[0],.001),4)}}};var Ml=class{constructor(t,e){this.canvas=t;this.scene=e;this.painted=[];this.hidden=new Set;this.ctx=t.getContext("2d"),this.colours=e.bodies.map(Es)}recolour(){this.colours=this.scene.bodies.map(Es)}resize(t,e,n){this.canvas.width=Math.round(t*n),this.canvas.height=Math.round(e*n)}draw(t,e,n){let{ctx:s,scene:r}=this,o=this.canvas.width/t.width;s.setTransform(o,0,0,o,0,0),s.fillStyle=jt.paper,s.fillRect(
0,0,t.width,t.height),t.isPlanar&&wy(s,t);let a=r.grounds.map(u=>({shape:u,facing:It(r.plane(u,e).n,t.toward)}));a.sort((u,h)=>u.facing-h.facing);for(let u of a)u.facing>=-.001&&Pp(s,t,u.shape,r,e);this.painted=[];let c=r.bodies.map((u,h)=>({item:As[u.kind](u,r.shapePose(u,e),r.film.pose(u.frameEnd??-1,e)),frame:u.frame,colour:this.colours[h],depth:0})).filter((u,h)=>!this.hidden.has(u.frame)&&!r.
absent(r.bodies[h],e));for(let{item:u,frame:h,colour:f}of My(c,t)){let d=u.paint(s,t,f);this.painted.push({path:d,frame:h}),h>=0&&h===n&&(s.strokeStyle=jt.accent,s.lineWidth=3,s.stroke(d))}for(let u of a)u.facing<-.001&&Pp(s,t,u.shape,r,e)}pick(t,e){this.ctx.setTransform(1,0,0,1,0,0);for(let n=this.painted.length-1;n>=0;--n)if(this.ctx.isPointInPath(this.painted[n].path,t,e))return this.painted[n].
frame;return-2}};function My(i,t){for(let r of i)r.depth=t.depth(r.item.centre);if(i.sort((r,o)=>r.depth-o.depth),t.isPlanar||i.length>200)return i;let e=[],n=new Set,s=r=>{if(!n.has(r)){n.add(r);for(let o of i)o!==r&&Sy(o.item,r.item,t)&&s(o);e.push(r)}};return i.forEach(s),e}function Sy(i,t,e){let n=(s,r)=>Rp(s,r,e,1)||Rp(r,s,e,-1);return n(i,t)&&!n(t,i)}function Rp(i,t,e,n){return i.planes.some(
({n:s,o:r})=>n*It(s,e.toward)>1e-6&&t.least(s)>=r-1e-9-1e-4*Math.abs(r))}function wy(i,t){let e=t.unproject(0,t.height),n=t.unproject(t.width,0),s=ji(0,t.width/t.scale,Math.max(4,Math.round(t.width/90))).step;i.lineWidth=1;for(let[r,o]of[[t.right,!0],[t.up,!1]])for(let a=Math.ceil(It(e,r)/s);a*s<=It(n,r);++a){let l=_t(t.centre,yt(r,a*s-It(t.centre,r))),[c,u]=t.project(l).map(h=>Math.round(h)+.5);i.
strokeStyle=a===0?jt.gridZero:jt.grid,i.beginPath(),o?(i.moveTo(c,0),i.lineTo(c,t.height)):(i.moveTo(0,u),i.lineTo(t.width,u)),i.stroke()}}function Pp(i,t,e,n,s){let r=n.plane(e,s),o=It(r.n,t.toward);if(Math.abs(o)<.02){let u=n.endsOf(e,s).filter(h=>Math.abs(It(h.n,t.toward))<.02);Ey(i,t,r,u,n.extent.size);return}if(t.isPlanar)return;let{outline:a,lines:l}=n.sheet(e,s,.75,12),c=$e(a.map(u=>t.project(
u)));if(i.fillStyle=o>0?jt.ground:jt.sheet,i.fill(c),i.strokeStyle=jt.groundLine,i.lineWidth=1,o<0){i.stroke(c);return}for(let u of l)i.stroke($e(u.map(h=>t.project(h)),!1))}function Ey(i,t,{c:e,n},s,r){let o=t.project(e),a=[It(n,t.right),-It(n,t.up)],l=[-a[1],a[0]],c=t.width+t.height,u=(t.width/2-o[0])*l[0]+(t.height/2-o[1])*l[1],h=Math.floor((u-c)/11),f=Math.ceil((u+c)/11),d=(b,T)=>[o[0]+l[0]*b-
a[0]*T,o[1]+l[1]*b-a[1]*T],g=yt(_t(yt(t.right,l[0]),yt(t.up,-l[1])),1/t.scale),v=xu(_t(e,yt(g,h*11)),_t(e,yt(g,f*11)),s,1e-6*r);if(!v)return;let[m,p]=v.map(b=>It(Zt(b,e),g)/It(g,g));i.save(),i.clip($e([d(m-14,-2),d(p+14,-2),d(p+14,15),d(m-14,15)])),i.fillStyle=jt.ground,i.fill($e([d(h*11,0),d(f*11,0),d(f*11,14),d(h*11,14)])),i.strokeStyle=jt.hatch,i.lineWidth=1.1,i.beginPath();for(let b=h;b<=f;++b){
let T=d(b*11+11,0),_=d(b*11,14);i.moveTo(T[0],T[1]),i.lineTo(_[0],_[1])}i.stroke(),i.restore(),i.strokeStyle=jt.edge,i.lineWidth=1.8,i.stroke($e([d(m,0),d(p,0)],!1))}var wu="system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",Ty=60,Ay=1500,Sl=class{constructor(t,e){this.canvas=t;this.film=e;this.hand=null;this.measure=null;this.other=null;this.labels=[];this.axes=!0;this.ctx=t.getContext("2d"),this.usualForce=e.usualForce(),this.usualImpact=e.usualImpact()}perUnit(t,e,n){let s=n?this.usualImpact:this.usualForce;return s>0?.1*e*t/s:0}resize(t,e,n){this.
canvas.width=Math.round(t*n),this.canvas.height=Math.round(e*n)}draw(t,e,n,s,r){let{ctx:o}=this,a=this.canvas.width/t.width;o.setTransform(a,0,0,a,0,0),o.clearRect(0,0,t.width,t.height),this.other?.paint(o,t,e),s.trails&&this.paintTrails(t,e),s.contacts&&this.paintContacts(t,e,n,r),this.hand&&this.paintHand(t,this.hand),this.paintLabels(t,e),this.measure?.on&&this.paintMeasure(t,this.measure,e),this.
axes&&Ry(o,t)}paintHand(t,e){let{ctx:n}=this,[s,r]=e.map(o=>t.project(o));n.strokeStyle=n.fillStyle=jt.accent,n.lineWidth=2,n.setLineDash([6,4]),n.stroke($e([s,r],!1)),n.setLineDash([]);for(let[o,a]of[s,r])n.beginPath(),n.arc(o,a,4.5,0,2*Math.PI),n.fill()}paintText(t,e,n,s=1/0){let{ctx:r}=this;r.font=`600 12px ${wu}`,r.textAlign="center",r.textBaseline="middle";let o=r.measureText(t).width+10;e>-o/
2&&e<s+o/2&&(e=Math.min(Math.max(e,o/2),Math.max(o/2,s-o/2))),r.globalAlpha=.85,r.fillStyle=jt.paper,r.fillRect(e-o/2,n-9,o,18),r.globalAlpha=1,r.fillStyle=jt.ink,r.fillText(t,e,n)}paintLabels(t,e){for(let{frame:n,text:s}of this.labels){if(this.film.absent(n,e))continue;let[r,o]=t.project(this.film.pose(n,e).r);this.paintText(s,r,o,t.width)}}paintMeasure(t,e,n){let{ctx:s}=this,r=e.points(n).map(o=>t.
project(o));s.strokeStyle=s.fillStyle=jt.accent,s.lineWidth=1.8,r.length===2&&s.stroke($e(r,!1));for(let[o,a]of r)s.beginPath(),s.arc(o,a,4,0,2*Math.PI),s.fill();r.length===2&&this.paintText(e.text(n).split("   ")[0],(r[0][0]+r[1][0])/2,(r[0][1]+r[1][1])/2-14)}paintTrails(t,e){let{film:n,ctx:s}=this,r=n.indexAt(e),o=Math.max(1,Math.ceil(r/600));s.lineWidth=1.4;for(let a=0;a<Math.min(n.poses,60);++a){
if(!n.moves(a))continue;let l=[],c=u=>{n.absent(a,u)||l.push(t.project(n.pose(a,u).r))};for(let u=0;u<=r;u+=o)c(n.t[u]);c(e),s.strokeStyle=Ye(Jo[a%Jo.length],jt.dark?0:.2),s.stroke($e(l,!1))}}paintContacts(t,e,n,s){let{ctx:r}=this,o=this.film.contacts(e),a=[!1,!0].map(d=>this.perUnit(n,s,d)),l=d=>a[d.state===Ms?1:0]*Yo(d),c=o.length<=Ay,u=.3*Math.min(t.width,t.height);if(o.length<=Ty)for(let d of o)
this.paintCone(t,d,l(d),u);let h=En.map(()=>new Path2D),f=En.map(()=>new Path2D);for(let d of o){let g=En[d.state]?d.state:0,v=t.project(d.r),m=Cy(v,t.project(_t(d.r,yt(d.F,l(d)))),u);c?(f[g].moveTo(v[0]+3,v[1]),f[g].arc(v[0],v[1],3,0,2*Math.PI),Math.hypot(m[0]-v[0],m[1]-v[1])>3&&Ip(h[g],f[g],v,m)):(h[g].moveTo(v[0],v[1]),h[g].lineTo(m[0],m[1]))}r.lineCap="butt",En.forEach(({colour:d},g)=>{r.strokeStyle=
r.fillStyle=jt.dark?Ye(d,.2):d,r.lineWidth=c?2.4:1.2,r.stroke(h[g]),r.fill(f[g])})}paintCone(t,e,n,s){let r=It(e.F,e.n);if(!(e.limit>0)||!(r>0)||e.limit>2*r)return;let{ctx:o}=this,a=(En[e.state]??En[0]).colour,l=t.project(e.r),c=t.project(_t(e.r,yt(e.F,n))),u=Math.hypot(c[0]-l[0],c[1]-l[1]),h=n*(u>s?s/u:1),f=_t(e.r,yt(e.n,r*h)),d=Qa(e.n),g=rn(e.n,d),v=vl(f,d,g,e.limit*h,36).map(T=>t.project(T));if(Math.
hypot(v[0][0]-v[18][0],v[0][1]-v[18][1])+Math.hypot(v[9][0]-v[27][0],v[9][1]-v[27][1])<5)return;let m=[t.project(f)[0]-l[0],t.project(f)[1]-l[1]],p=T=>m[0]*(T[1]-l[1])-m[1]*(T[0]-l[0]),b=v.slice().sort((T,_)=>p(T)-p(_));o.fillStyle=a+"24",o.fill($e([l,b[0],b[b.length-1]])),o.fill($e(v)),o.strokeStyle=a+"90",o.lineWidth=1.2,o.stroke($e(v)),o.stroke($e([b[0],l,b[b.length-1]],!1))}};function Cy(i,t,e){
let n=Math.hypot(t[0]-i[0],t[1]-i[1]);return n>e?[i[0]+(t[0]-i[0])*e/n,i[1]+(t[1]-i[1])*e/n]:t}function Ip(i,t,e,n){let s=Math.atan2(n[1]-e[1],n[0]-e[0]),r=Math.min(11,.6*Math.hypot(n[0]-e[0],n[1]-e[1])),o=a=>[n[0]-r*Math.cos(s+a),n[1]-r*Math.sin(s+a)];i.moveTo(e[0],e[1]),i.lineTo(n[0]-.8*r*Math.cos(s),n[1]-.8*r*Math.sin(s)),t.addPath($e([n,o(.42),o(-.42)]))}function Ry(i,t){let e=t.height<420,n=[
e?34:44,t.height-(e?34:44)],s=e?22:30,r=[["x",[1,0,0],"#c2413b"],["y",[0,1,0],"#3f8f46"],["z",[0,0,1],jt.dark?"#5a93d6":"#2f6db5"]];r.sort((u,h)=>It(u[1],t.toward)-It(h[1],t.toward)),i.font=`600 13px ${wu}`,i.textAlign="center",i.textBaseline="middle";for(let[u,h,f]of r){let d=[It(h,t.right),-It(h,t.up)];if(Math.hypot(d[0],d[1])<.05)continue;i.strokeStyle=i.fillStyle=f,i.lineWidth=1.8;let g=new Path2D,
v=new Path2D;Ip(g,v,n,[n[0]+d[0]*s,n[1]+d[1]*s]),i.stroke(g),i.fill(v),i.fillText(u,n[0]+d[0]*(s+10),n[1]+d[1]*(s+10))}let o=ji(0,150/t.scale,2).step,a=o*t.scale,[l,c]=[n[0]+2*s+4,t.height-(e?24:30)];i.strokeStyle=i.fillStyle=jt.soft,i.lineWidth=1.4,i.stroke($e([[l,c-4],[l,c],[l+a,c],[l+a,c-4]],!1)),i.font=`12px ${wu}`,i.fillText(tp(o),l+a/2,c+11)}var rm=0,of=1,om=2;var af=1,Mc=2,Xi=3,as=0,zn=1,di=2,us=0,ir=1,lf=2,cf=3,hf=4,am=5,Ns=100,lm=101,cm=102,hm=103,um=104,fm=200,dm=201,pm=202,mm=203,Jl=204,Kl=205,gm=206,vm=207,ym=208,xm=209,_m=210,bm=211,Mm=212,Sm=213,wm=214,Sc=0,wc=1,Ec=2,sr=3,Tc=4,Ac=5,Cc=6,Rc=7,yo=0,Em=1,Tm=2,fs=0,Am=1,Cm=2,Rm=3,Pm=4,Im=5,Lm=6,Dm=7;var uf=300,fr=301,dr=302,Pc=303,Ic=304,Ca=306,jl=1e3,Fs=1001,Ql=1002,Xn=1003,Um=1004;var Ra=1005;var Ti=1006,Lc=1007;var ks=1008;var Ci=1009,ff=1010,df=1011,xo=1012,Dc=1013,zs=1014,Ri=1015,_o=1016,Uc=1017,Fc=1018,bo=1020,pf=35902,mf=35899,gf=1021,vf=1022,pi=1023,io=1026,Mo=1027,Nc=1028,Oc=1029,yf=1030,Bc=1031;var kc=1033,Pa=33776,Ia=33777,La=33778,Da=33779,zc=35840,Vc=35841,Hc=35842,Gc=35843,Wc=36196,Xc=37492,qc=37496,Yc=37808,$c=37809,Zc=37810,Jc=37811,Kc=37812,jc=37813,Qc=37814,th=37815,eh=37816,nh=37817,ih=37818,sh=37819,rh=37820,oh=37821,ah=36492,lh=36494,ch=36495,hh=36283,uh=36284,fh=36285,dh=36286;var ra=2300,tc=2301,$l=2302,Ju=2400,Ku=2401,ju=2402;var Fm=3200,Nm=3201;var ph=0,Om=1,ds="",ti="srgb",rr="srgb-linear",oa="linear",De="srgb";var er=7680;var Qu=519,Bm=512,km=513,zm=514,xf=515,Vm=516,Hm=517,Gm=518,Wm=519,tf=35044;var _f="300 es",Ei=2e3,aa=2001;var ls=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){
let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Rn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c",
"2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c",
"7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc",
"cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Zl=Math.PI/180,ec=180/Math.PI;function Ua(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Rn[i&255]+Rn[i>>8&255]+Rn[i>>16&255]+Rn[i>>24&255]+"-"+Rn[t&255]+Rn[t>>8&255]+"-"+Rn[t>>16&15|64]+Rn[t>>24&255]+"-"+Rn[e&63|128]+Rn[e>>8&255]+"-"+Rn[e>>16&255]+Rn[e>>24&255]+Rn[n&255]+Rn[n>>8&255]+Rn[n>>16&255]+Rn[n>>24&255]).
toLowerCase()}function ye(i,t,e){return Math.max(t,Math.min(e,i))}function Py(i,t){return(i%t+t)%t}function Eu(i,t,e){return(1-e)*i+e*t}function Ko(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Wn(i,t){switch(t.constructor){case Float32Array:
return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var ge=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error(
"index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){
return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.
x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){
let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.
y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.
lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,
this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*
s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ui=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}
if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a,p=l*f+c*d+u*g+h*v,b=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){let C=Math.sqrt(T),A=Math.atan2(C,p*b);m=Math.sin(m*A)/C,a=Math.sin(a*A)/C}let _=a*b;if(l=l*m+f*_,c=c*m+d*_,u=u*m+g*_,h=h*m+v*_,m===1-a){let C=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=C,c*=C,u*=C,h*=C}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){
let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){
this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),
d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+
f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=
t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>
h){let d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=
n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=
-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*
t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){
if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let d=1-e;return this._w=d*o+e*this._w,this._x=d*n+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this.
_z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.
set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(
e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.
z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:
throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.
z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){
return this.applyQuaternion(Lp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Lp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/
(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).
applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(
1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),
this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){
return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(
this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.
y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Tu.copy(this).projectOnVector(t),this.sub(Tu)}reflect(t){return this.sub(Tu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.
PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.
sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(
t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.
x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.
random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Tu=new H,Lp=new ui,le=class i{constructor(t,e,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=
r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.
set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],g=n[8],v=s[0],m=s[3],p=s[6],b=s[1],T=s[4],_=s[7],C=s[2],A=s[5],D=s[8];return r[0]=o*v+a*b+l*C,r[3]=o*m+a*T+l*A,r[6]=o*p+
a*_+l*D,r[1]=c*v+u*b+h*C,r[4]=c*m+u*T+h*A,r[7]=c*p+u*_+h*D,r[2]=f*v+d*b+g*C,r[5]=f*m+d*T+g*A,r[8]=f*p+d*_+g*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,
e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return t[0]=h*v,t[1]=(s*c-u*n)*v,t[2]=(a*n-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=
e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(
Au.makeScale(t,e)),this}rotate(t){return this.premultiply(Au.makeRotation(-t)),this}translate(t,e){return this.premultiply(Au.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){
let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Au=new le;function bf(i){
for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function la(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Xm(){let i=la("canvas");return i.style.display="block",i}var Dp={};function so(i){i in Dp||(Dp[i]=!0,console.warn(i))}function qm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:
n()}}setTimeout(r,e)})}var Up=new le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fp=new le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Iy(){let i={enabled:!0,workingColorSpace:rr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===De&&(s.r=os(s.r),
s.g=os(s.g),s.b=os(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===De&&(s.r=no(s.r),s.g=no(s.g),s.b=no(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){
return this.spaces[s].primaries},getTransfer:function(s){return s===ds?oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){
return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return so("THREE.ColorManagement: .fromWorkingColorSpace() has b\
een renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return so("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[rr]:{primaries:t,whitePoint:n,transfer:oa,toXYZ:Up,fromXYZ:Fp,luminanceCoefficients:e,
workingColorSpaceConfig:{unpackColorSpace:ti},outputColorSpaceConfig:{drawingBufferColorSpace:ti}},[ti]:{primaries:t,whitePoint:n,transfer:De,toXYZ:Up,fromXYZ:Fp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ti}}}),i}var _e=Iy();function os(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function no(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-
.055}var Gr,nc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Gr===void 0&&(Gr=la("canvas")),Gr.width=t.width,Gr.height=t.height;let s=Gr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Gr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<
"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=la("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=os(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.
data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(os(e[n]/255)*255):e[n]=os(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ly=0,ro=class{constructor(t=null){this.isSource=!0,Object.defineProperty(
this,"id",{value:Ly++}),this.uuid=Ua(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||
typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Cu(s[o].image)):r.push(Cu(s[o]))}else r=Cu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Cu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||
typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?nc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Dy=0,Ru=new H,qn=class i extends ls{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Ti,o=ks,a=pi,l=Ci,c=i.
DEFAULT_ANISOTROPY,u=ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=Ua(),this.name="",this.source=new ro(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ge(0,0),this.repeat=new ge(1,1),this.center=new ge(0,0),this.rotation=
0,this.matrixAutoUpdate=!0,this.matrix=new le,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Ru).x}get height(){return this.
source.getSize(Ru).y}get depth(){return this.source.getSize(Ru).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.
constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),
this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,
this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||
s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.
x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};
return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==uf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case jl:t.x=t.x-Math.floor(t.x);break;case Fs:t.x=t.x<0?0:1;break;case Ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(
t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case jl:t.y=t.y-Math.floor(t.y);break;case Fs:t.y=t.y<0?0:1;break;case Ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};qn.DEFAULT_IMAGE=null;qn.DEFAULT_MAPPING=
uf;qn.DEFAULT_ANISOTROPY=1;var tn=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.
y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of r\
ange: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.
x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=
t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*
Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.
set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,_=(d+1)/2,C=(p+1)/2,A=(u+f)/4,D=(h+v)/4,F=(g+m)/4;return T>_&&T>C?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=A/n,r=D/n):_>C?_<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(_),n=A/s,r=F/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=D/r,s=F/r),this.set(n,s,r,e),this}let b=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.
abs(b)<.001&&(b=1),this.x=(m-g)/b,this.y=(h-v)/b,this.z=(f-u)/b,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,
t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,
e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.
trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=
t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.
y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ic=class extends ls{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ti,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),
this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new tn(0,0,t,e),this.scissorTest=!1,this.viewport=new tn(0,0,t,e);let s={width:t,height:e,depth:n.depth},r=new qn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.
depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){let e={minFilter:Ti,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&
(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==
void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){
return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,
e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.
assign({},t.textures[e].image);this.textures[e].source=new ro(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Hi=class extends ic{constructor(t=1,e=1,n={}){
super(t,e,n),this.isWebGLRenderTarget=!0}},ca=class extends qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Xn,this.minFilter=Xn,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Xn,this.minFilter=Xn,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Gi=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Mi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Mi.fromBufferAttribute(t,e));return this}setFromPoints(t){
this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Mi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){
return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(
t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Mi):Mi.fromBufferAttribute(r,
o),Mi.applyMatrix4(t.matrixWorld),this.expandByPoint(Mi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),wl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),wl.copy(n.boundingBox)),wl.applyMatrix4(t.matrixWorld),this.union(wl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&
t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){
return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Mi),Mi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=
t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(jo),El.subVectors(this.max,jo),Wr.subVectors(t.a,jo),Xr.subVectors(t.b,jo),qr.subVectors(
t.c,jo),Rs.subVectors(Xr,Wr),Ps.subVectors(qr,Xr),Ks.subVectors(Wr,qr);let e=[0,-Rs.z,Rs.y,0,-Ps.z,Ps.y,0,-Ks.z,Ks.y,Rs.z,0,-Rs.x,Ps.z,0,-Ps.x,Ks.z,0,-Ks.x,-Rs.y,Rs.x,0,-Ps.y,Ps.x,0,-Ks.y,Ks.x,0];return!Pu(e,Wr,Xr,qr,El)||(e=[1,0,0,0,1,0,0,0,1],!Pu(e,Wr,Xr,qr,El))?!1:(Tl.crossVectors(Rs,Ps),e=[Tl.x,Tl.y,Tl.z],Pu(e,Wr,Xr,qr,El))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){
return this.clampPoint(t,Mi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Mi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ts[0].set(this.min.x,this.min.
y,this.min.z).applyMatrix4(t),ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ts[7].set(
this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ts),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ts=[new H,new H,new H,new H,new H,new H,new H,new H],Mi=new H,
wl=new Gi,Wr=new H,Xr=new H,qr=new H,Rs=new H,Ps=new H,Ks=new H,jo=new H,El=new H,Tl=new H,js=new H;function Pu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){js.fromArray(i,r);let a=s.x*Math.abs(js.x)+s.y*Math.abs(js.y)+s.z*Math.abs(js.z),l=t.dot(js),c=e.dot(js),u=n.dot(js);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Uy=new Gi,Qo=new H,Iu=new H,cs=class{constructor(t=new H,e=-1){
this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Uy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<
0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(
this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*
t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qo.subVectors(t,this.center);let e=Qo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):
(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Iu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qo.copy(t.center).add(Iu)),this.expandByPoint(Qo.copy(t.center).sub(Iu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.
center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},es=new H,Lu=new H,Al=new H,Is=new H,Du=new H,Cl=new H,Uu=new H,oo=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(
this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,es)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(
t))}distanceSqToPoint(t){let e=es.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(es.copy(this.origin).addScaledVector(this.direction,e),es.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Lu.copy(t).add(e).multiplyScalar(.5),Al.copy(e).sub(t).normalize(),Is.copy(this.origin).sub(Lu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Al),a=Is.dot(this.direction),
l=-Is.dot(Al),c=Is.lengthSq(),u=Math.abs(1-o*o),h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=
f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Lu).addScaledVector(Al,f),d}intersectSphere(t,e){es.subVectors(t.center,this.origin);let n=es.dot(this.direction),s=es.dot(es)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.
sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===
null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.
y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,es)!==null}intersectTriangle(t,e,n,s,r){Du.subVectors(e,t),Cl.subVectors(n,t),Uu.crossVectors(Du,Cl);let o=this.direction.dot(Uu),
a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Is.subVectors(this.origin,t);let l=a*this.direction.dot(Cl.crossVectors(Is,Cl));if(l<0)return null;let c=a*this.direction.dot(Du.cross(Is));if(c<0||l+c>o)return null;let u=-a*Is.dot(Uu);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.
equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},de=class i{constructor(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=
a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=
n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,
n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Yr.setFromMatrixColumn(t,0).length(),r=1/Yr.setFromMatrixColumn(t,1).length(),o=1/Yr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){
let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*
l}else if(t.order==="ZXY"){let f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=
-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Fy,t,Ny)}lookAt(t,e,n){let s=this.elements;return jn.subVectors(t,e),jn.lengthSq()===0&&(jn.z=1),jn.normalize(),Ls.
crossVectors(n,jn),Ls.lengthSq()===0&&(Math.abs(n.z)===1?jn.x+=1e-4:jn.z+=1e-4,jn.normalize(),Ls.crossVectors(n,jn)),Ls.normalize(),Rl.crossVectors(jn,Ls),s[0]=Ls.x,s[4]=Rl.x,s[8]=jn.x,s[1]=Ls.y,s[5]=Rl.y,s[9]=jn.y,s[2]=Ls.z,s[6]=Rl.z,s[10]=jn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,
r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],g=n[2],v=n[6],m=n[10],p=n[14],b=n[3],T=n[7],_=n[11],C=n[15],A=s[0],D=s[4],F=s[8],w=s[12],S=s[1],R=s[5],O=s[9],z=s[13],W=s[2],X=s[6],q=s[10],Z=s[14],j=s[3],rt=s[7],ot=s[11],vt=s[15];return r[0]=o*A+a*S+l*W+c*j,r[4]=o*D+a*R+l*X+c*rt,r[8]=o*F+a*O+l*q+c*ot,r[12]=o*w+a*z+l*Z+c*vt,r[1]=u*A+h*S+f*W+d*j,r[5]=u*D+h*R+f*X+d*rt,r[9]=u*
F+h*O+f*q+d*ot,r[13]=u*w+h*z+f*Z+d*vt,r[2]=g*A+v*S+m*W+p*j,r[6]=g*D+v*R+m*X+p*rt,r[10]=g*F+v*O+m*q+p*ot,r[14]=g*w+v*z+m*Z+p*vt,r[3]=b*A+T*S+_*W+C*j,r[7]=b*D+T*R+_*X+C*rt,r[11]=b*F+T*O+_*q+C*ot,r[15]=b*w+T*z+_*Z+C*vt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,
this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*d-n*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+n*o*d+r*a*u-n*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],
t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],b=h*m*
c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,_=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,C=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,A=e*b+n*T+s*_+r*C;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/A;return t[0]=b*D,t[1]=(v*f*r-h*m*r-v*s*d+n*m*d+h*s*p-n*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-n*m*c-a*s*p+n*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*d-n*l*d)*D,t[4]=T*D,t[5]=(u*
m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=_*D,t[9]=(g*h*r-u*v*r-g*n*d+e*v*d+u*n*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*n*c-e*v*c-o*n*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*d-e*a*d)*D,t[12]=C*D,t[13]=(u*v*s-g*h*s+g*n*f-e*v*f-u*n*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*n*l+e*v*l+o*n*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*n*l-
e*h*l-o*n*f+e*a*f)*D,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.
set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){
let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,
f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,b=l*c,T=l*u,_=l*h,C=n.x,A=n.y,D=n.z;return s[0]=(1-(v+p))*C,s[1]=(d+_)*C,s[2]=(g-T)*C,s[3]=0,s[4]=(d-_)*A,s[5]=(1-(f+p))*A,s[6]=(m+b)*A,s[7]=0,s[8]=(g+T)*D,s[9]=(m-b)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),a=Yr.set(s[8],s[9],s[10]).
length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Si.copy(this);let c=1/r,u=1/o,h=1/a;return Si.elements[0]*=c,Si.elements[1]*=c,Si.elements[2]*=c,Si.elements[4]*=u,Si.elements[5]*=u,Si.elements[6]*=u,Si.elements[8]*=h,Si.elements[9]*=h,Si.elements[10]*=h,e.setFromRotationMatrix(Si),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ei,l=!1){let c=this.elements,u=2*r/(e-t),h=2*
r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ei)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===aa)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ei,l=!1){
let c=this.elements,u=2/(e-t),h=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ei)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===aa)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){
let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=
n[15],t}},Yr=new H,Si=new de,Fy=new H(0,0,0),Ny=new H(1,1,1),Ls=new H,Rl=new H,jn=new H,Np=new de,Op=new ui,fi=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this.
_onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this.
_order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this.
_z=0);break;case"ZXY":this._x=Math.asin(ye(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(
-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){
return Np.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Np,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Op.setFromEuler(this),this.setFromQuaternion(Op,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),
this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};fi.DEFAULT_ORDER="XYZ";var ao=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){
this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Oy=0,Bp=new H,$r=new ui,ns=new de,Pl=new H,ta=new H,By=new H,ky=new ui,kp=new H(1,0,0),zp=new H(0,1,0),Vp=new H(0,0,1),Hp={type:"added"},zy={type:"removed"},Zr={type:"childadded",child:null},Fu={type:"childremoved",child:null},Tn=class i extends ls{constructor(){
super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Oy++}),this.uuid=Ua(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new H,e=new fi,n=new ui,s=new H(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,
value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new de},normalMatrix:{value:new le}}),this.matrix=new de,this.matrixWorld=new de,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=
!1,this.layers=new ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(
this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return $r.setFromAxisAngle(t,e),
this.quaternion.multiply($r),this}rotateOnWorldAxis(t,e){return $r.setFromAxisAngle(t,e),this.quaternion.premultiply($r),this}rotateX(t){return this.rotateOnAxis(kp,t)}rotateY(t){return this.rotateOnAxis(zp,t)}rotateZ(t){return this.rotateOnAxis(Vp,t)}translateOnAxis(t,e){return Bp.copy(t).applyQuaternion(this.quaternion),this.position.add(Bp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(
kp,t)}translateY(t){return this.translateOnAxis(zp,t)}translateZ(t){return this.translateOnAxis(Vp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ns.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Pl.copy(t):Pl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ta.setFromMatrixPosition(
this.matrixWorld),this.isCamera||this.isLight?ns.lookAt(ta,Pl,this.up):ns.lookAt(Pl,ta,this.up),this.quaternion.setFromRotationMatrix(ns),s&&(ns.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(ns),this.quaternion.premultiply($r.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: o\
bject can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Hp),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.
children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(zy),Fu.child=t,this.dispatchEvent(Fu),Fu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ns.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),
ns.multiply(t.parent.matrixWorld)),t.applyMatrix4(ns),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Hp),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.
children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,
!1),this.matrixWorld.decompose(ta,t,By),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,ky,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;
t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&
(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===
!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,
type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),
s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,
s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=
this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.
toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():
this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(
l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));
s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),
u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){
return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=
t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};Tn.
DEFAULT_UP=new H(0,1,0);Tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wi=new H,is=new H,Nu=new H,ss=new H,Jr=new H,Kr=new H,Gp=new H,Ou=new H,Bu=new H,ku=new H,zu=new tn,Vu=new tn,Hu=new tn,rs=class i{constructor(t=new H,e=new H,n=new H){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),wi.subVectors(t,e),s.cross(wi);let r=s.lengthSq();return r>0?
s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){wi.subVectors(s,e),is.subVectors(n,e),Nu.subVectors(t,e);let o=wi.dot(wi),a=wi.dot(is),l=wi.dot(Nu),c=is.dot(is),u=is.dot(Nu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ss)===null?!1:ss.x>=0&&ss.y>=
0&&ss.x+ss.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ss)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ss.x),l.addScaledVector(o,ss.y),l.addScaledVector(a,ss.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return zu.setScalar(0),Vu.setScalar(0),Hu.setScalar(0),zu.fromBufferAttribute(t,e),Vu.fromBufferAttribute(
t,n),Hu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(Vu,r.y),o.addScaledVector(Hu,r.z),o}static isFrontFacing(t,e,n,s){return wi.subVectors(n,e),is.subVectors(t,e),wi.cross(is).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){
return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return wi.subVectors(this.c,this.b),is.subVectors(this.a,this.b),wi.cross(is).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(
1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.
c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Jr.subVectors(s,n),Kr.subVectors(r,n),Ou.subVectors(t,n);let l=Jr.dot(Ou),c=Kr.dot(Ou);if(l<=0&&c<=0)return e.copy(n);Bu.subVectors(t,s);let u=Jr.dot(Bu),h=Kr.dot(Bu);if(u>=0&&h<=u)return e.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(Jr,o);ku.
subVectors(t,r);let d=Jr.dot(ku),g=Kr.dot(ku);if(g>=0&&d<=g)return e.copy(r);let v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(Kr,a);let m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return Gp.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(Gp,a);let p=1/(m+v+f);return o=v*p,a=f*p,e.copy(n).addScaledVector(Jr,o).addScaledVector(Kr,a)}equals(t){return t.a.equals(this.a)&&
t.b.equals(this.b)&&t.c.equals(this.c)}},Ym={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,
darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,
dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,
lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,
maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,
orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,
skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ds={h:0,s:0,l:0},Il={h:0,s:0,l:0};function Gu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:
e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ce=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ti){return t=Math.floor(t),
this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=n,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=_e.workingColorSpace){if(t=Py(t,1),e=ye(e,0,1),n=ye(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Gu(o,r,t+1/3),this.g=Gu(o,r,t),this.b=Gu(o,
r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=ti){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(
r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.
exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn(
"THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ti){let n=Ym[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=os(t.r),this.g=os(t.g),
this.b=os(t.b),this}copyLinearToSRGB(t){return this.r=no(t.r),this.g=no(t.g),this.b=no(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ti){return _e.workingToColorSpace(Pn.copy(this),t),Math.round(ye(Pn.r*255,0,255))*65536+Math.round(ye(Pn.g*255,0,255))*256+Math.round(ye(Pn.b*255,0,255))}getHexString(t=ti){
return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(Pn.copy(this),e);let n=Pn.r,s=Pn.g,r=Pn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.
workingColorSpace){return _e.workingToColorSpace(Pn.copy(this),e),t.r=Pn.r,t.g=Pn.g,t.b=Pn.b,t}getStyle(t=ti){_e.workingToColorSpace(Pn.copy(this),t);let e=Pn.r,n=Pn.g,s=Pn.b;return t!==ti?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ds),this.setHSL(Ds.h+t,Ds.s+e,Ds.l+n)}add(t){
return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){
return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ds),t.getHSL(Il);let n=Eu(Ds.h,Il.h,e),s=Eu(Ds.s,Il.s,e),r=Eu(Ds.l,Il.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.
r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(
e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Pn=new ce;ce.NAMES=Ym;var Vy=0,Wi=class extends ls{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vy++}),this.uuid=Ua(),this.name="",this.type="Material",this.blending=ir,this.side=as,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=
Jl,this.blendDst=Kl,this.blendEquation=Ns,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=sr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Qu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=er,this.stencilZFail=er,this.stencilZPass=er,this.stencilWrite=!1,this.clippingPlanes=
null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){
return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Mat\
erial: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=
this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.
emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),
this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.
isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),
this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&
(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&
(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=
this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),
this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&
this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.
toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.
transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=
this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ir&&(n.blending=this.blending),this.side!==as&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=
!0),this.blendSrc!==Jl&&(n.blendSrc=this.blendSrc),this.blendDst!==Kl&&(n.blendDst=this.blendDst),this.blendEquation!==Ns&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.
isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==sr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Qu&&
(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==er&&(n.stencilFail=this.stencilFail),this.stencilZFail!==er&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==er&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==
void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&
(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>
1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.
userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,
this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=
t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.
clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,
this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},or=class extends Wi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,
this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fi,this.combine=yo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.
map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var on=new H,Ll=new ge,Hy=0,Ln=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Hy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=tf,this.updateRanges=[],this.gpuType=Ri,this.version=0}onUploadCallback(){}set needsUpdate(t){
t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.
itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ll.fromBufferAttribute(this,e),Ll.applyMatrix3(t),this.setXY(e,Ll.x,Ll.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)on.fromBufferAttribute(this,e),on.applyMatrix3(t),this.setXYZ(e,on.x,
on.y,on.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)on.fromBufferAttribute(this,e),on.applyMatrix4(t),this.setXYZ(e,on.x,on.y,on.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)on.fromBufferAttribute(this,e),on.applyNormalMatrix(t),this.setXYZ(e,on.x,on.y,on.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)on.fromBufferAttribute(this,e),
on.transformDirection(t),this.setXYZ(e,on.x,on.y,on.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Ko(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Wn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Ko(e,this.array)),
e}setX(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Ko(e,this.array)),e}setY(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Ko(e,this.array)),e}setZ(t,e){return this.normalized&&
(e=Wn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Ko(e,this.array)),e}setW(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=
this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array),s=Wn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array),s=Wn(s,this.array),r=Wn(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=
t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==tf&&(t.usage=this.usage),t}};var ha=class extends Ln{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ua=class extends Ln{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var pe=class extends Ln{constructor(t,e,n){super(new Float32Array(t),e,n)}},Gy=0,hi=new de,Wu=new Tn,jr=new H,Qn=new Gi,ea=new Gi,_n=new H,Qe=class i extends ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Gy++}),this.uuid=Ua(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=
!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(bf(t)?ua:ha)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){
return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new le().
getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return hi.makeRotationFromQuaternion(t),this.applyMatrix4(hi),this}rotateX(t){return hi.makeRotationX(t),this.applyMatrix4(
hi),this}rotateY(t){return hi.makeRotationY(t),this.applyMatrix4(hi),this}rotateZ(t){return hi.makeRotationZ(t),this.applyMatrix4(hi),this}translate(t,e,n){return hi.makeTranslation(t,e,n),this.applyMatrix4(hi),this}scale(t,e,n){return hi.makeScale(t,e,n),this.applyMatrix4(hi),this}lookAt(t){return Wu.lookAt(t),Wu.updateMatrix(),this.applyMatrix4(Wu.matrix),this}center(){return this.computeBoundingBox(),
this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new pe(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.Buff\
erGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),
this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];Qn.setFromBufferAttribute(r),this.morphTargetsRelative?(_n.addVectors(this.boundingBox.min,Qn.min),this.boundingBox.expandByPoint(_n),_n.addVectors(this.boundingBox.max,Qn.max),this.boundingBox.expandByPoint(_n)):(this.boundingBox.
expandByPoint(Qn.min),this.boundingBox.expandByPoint(Qn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.
boundingSphere=new cs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let n=this.boundingSphere.center;if(Qn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ea.setFromBufferAttribute(
a),this.morphTargetsRelative?(_n.addVectors(Qn.min,ea.min),Qn.expandByPoint(_n),_n.addVectors(Qn.max,ea.max),Qn.expandByPoint(_n)):(Qn.expandByPoint(ea.min),Qn.expandByPoint(ea.max))}Qn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)_n.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(_n));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<
u;c++)_n.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(t,c),_n.add(jr)),s=Math.max(s,n.distanceToSquared(_n))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||
e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Ln(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let F=0;F<n.count;F++)a[F]=
new H,l[F]=new H;let c=new H,u=new H,h=new H,f=new ge,d=new ge,g=new ge,v=new H,m=new H;function p(F,w,S){c.fromBufferAttribute(n,F),u.fromBufferAttribute(n,w),h.fromBufferAttribute(n,S),f.fromBufferAttribute(r,F),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);let R=1/(d.x*g.y-g.x*d.y);isFinite(R)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(
R),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(R),a[F].add(v),a[w].add(v),a[S].add(v),l[F].add(m),l[w].add(m),l[S].add(m))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let F=0,w=b.length;F<w;++F){let S=b[F],R=S.start,O=S.count;for(let z=R,W=R+O;z<W;z+=3)p(t.getX(z+0),t.getX(z+1),t.getX(z+2))}let T=new H,_=new H,C=new H,A=new H;function D(F){C.fromBufferAttribute(
s,F),A.copy(C);let w=a[F];T.copy(w),T.sub(C.multiplyScalar(C.dot(w))).normalize(),_.crossVectors(A,w);let R=_.dot(l[F])<0?-1:1;o.setXYZW(F,T.x,T.y,T.z,R)}for(let F=0,w=b.length;F<w;++F){let S=b[F],R=S.start,O=S.count;for(let z=R,W=R+O;z<W;z+=3)D(t.getX(z+0)),D(t.getX(z+1)),D(t.getX(z+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute(
"normal");if(n===void 0)n=new Ln(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(
s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(
f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)_n.fromBufferAttribute(t,e),_n.normalize(),t.setXYZ(e,_n.x,_n.y,_n.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?
d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new Ln(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<
h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(
this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.
morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.
constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(
h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,
this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wp=new de,Qs=new oo,Dl=new cs,Xp=new H,Ul=new H,Fl=new H,Nl=new H,Xu=new H,Ol=new H,qp=new H,Bl=new H,An=class extends Tn{constructor(t=new Qe,e=new or){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){
return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.
length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;
if(r&&a){Ol.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Xu.fromBufferAttribute(h,t),o?Ol.addScaledVector(Xu,u):Ol.addScaledVector(Xu.sub(e),u))}e.add(Ol)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Dl.copy(n.boundingSphere),Dl.applyMatrix4(r),Qs.copy(t.ray).recast(t.near),!(Dl.
containsPoint(Qs.origin)===!1&&(Qs.intersectSphere(Dl,Xp)===null||Qs.origin.distanceToSquared(Xp)>(t.far-t.near)**2))&&(Wp.copy(r).invert(),Qs.copy(t.ray).applyMatrix4(Wp),!(n.boundingBox!==null&&Qs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Qs)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.
uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let m=f[g],p=o[m.materialIndex],b=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let _=b,C=T;_<C;_+=3){let A=a.getX(_),D=a.getX(_+1),F=a.getX(_+2);s=kl(this,p,t,n,c,u,h,A,D,F),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=m.materialIndex,
e.push(s))}}else{let g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){let b=a.getX(m),T=a.getX(m+1),_=a.getX(m+2);s=kl(this,o,t,n,c,u,h,b,T,_),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let m=f[g],p=o[m.materialIndex],b=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+
d.count));for(let _=b,C=T;_<C;_+=3){let A=_,D=_+1,F=_+2;s=kl(this,p,t,n,c,u,h,A,D,F),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){let b=m,T=m+1,_=m+2;s=kl(this,o,t,n,c,u,h,b,T,_),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Wy(i,t,e,n,s,r,o,a){let l;if(t.side===
zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===as,a),l===null)return null;Bl.copy(a),Bl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Bl);return c<e.near||c>e.far?null:{distance:c,point:Bl.clone(),object:i}}function kl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Ul),i.getVertexPosition(l,Fl),i.getVertexPosition(c,Nl);let u=Wy(i,t,e,n,Ul,Fl,Nl,qp);if(u){let h=new H;
rs.getBarycoord(qp,Ul,Fl,Nl,h),s&&(u.uv=rs.getInterpolatedAttribute(s,a,l,c,h,new ge)),r&&(u.uv1=rs.getInterpolatedAttribute(r,a,l,c,h,new ge)),o&&(u.normal=rs.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new H,materialIndex:0};rs.getNormal(Ul,Fl,Nl,f.normal),u.face=f,u.barycoord=h}return u}var hs=class i extends Qe{constructor(t=1,e=1,n=1,s=1,r=1,o=1){
super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,
-n,s,r,5),this.setIndex(l),this.setAttribute("position",new pe(c,3)),this.setAttribute("normal",new pe(u,3)),this.setAttribute("uv",new pe(h,2));function g(v,m,p,b,T,_,C,A,D,F,w){let S=_/D,R=C/F,O=_/2,z=C/2,W=A/2,X=D+1,q=F+1,Z=0,j=0,rt=new H;for(let ot=0;ot<q;ot++){let vt=ot*R-z;for(let bt=0;bt<X;bt++){let pt=bt*S-O;rt[v]=pt*b,rt[m]=vt*T,rt[p]=W,c.push(rt.x,rt.y,rt.z),rt[v]=0,rt[m]=0,rt[p]=A>0?1:-1,
u.push(rt.x,rt.y,rt.z),h.push(bt/D),h.push(1-ot/F),Z+=1}}for(let ot=0;ot<F;ot++)for(let vt=0;vt<D;vt++){let bt=f+vt+X*ot,pt=f+vt+X*(ot+1),se=f+(vt+1)+X*(ot+1),Kt=f+(vt+1)+X*ot;l.push(bt,pt,Kt),l.push(pt,se,Kt),j+=6}a.addGroup(d,j,w),d+=j,f+=Z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.
heightSegments,t.depthSegments)}};function pr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.
isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Dn(i){let t={};for(let e=0;e<i.length;e++){let n=pr(i[e]);for(let s in n)t[s]=n[s]}return t}function Xy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Mf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var $m={clone:pr,merge:Dn},
qy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Yy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ai=class extends Wi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=qy,this.fragmentShader=Yy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues=
{color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=pr(t.uniforms),this.uniformsGroups=Xy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.
getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=
this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},fa=class extends Tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new de,this.projectionMatrix=new de,this.projectionMatrixInverse=new de,
this.coordinateSystem=Ei,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){
super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Us=new H,Yp=new ge,$p=new ge,In=class extends fa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,
this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){
let e=.5*this.getFilmHeight()/t;this.fov=ec*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Zl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ec*2*Math.atan(Math.tan(Zl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Us.set(-1,
-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Us.x,Us.y).multiplyScalar(-t/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Us.x,Us.y).multiplyScalar(-t/Us.z)}getViewSize(t,e){return this.getViewBounds(t,Yp,$p),e.subVectors($p,Yp)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),
this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Zl*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&
this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,
e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Qr=-90,to=1,rc=class extends Tn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=
0;let s=new In(Qr,to,t,e);s.layers=this.layers,this.add(s);let r=new In(Qr,to,t,e);r.layers=this.layers,this.add(r);let o=new In(Qr,to,t,e);o.layers=this.layers,this.add(o);let a=new In(Qr,to,t,e);a.layers=this.layers,this.add(a);let l=new In(Qr,to,t,e);l.layers=this.layers,this.add(l);let c=new In(Qr,to,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.
children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ei)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===aa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),
o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.
coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),
t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=v,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},da=class extends qn{constructor(t=[],e=fr,n,s,r,o,a,l,c,u){super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},oc=class extends Hi{constructor(t=1,e={}){
super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new da(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={
uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new hs(5,5,5),r=new Ai({name:"CubemapFromEquirect",uniforms:pr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:zn,blending:us});r.uniforms.tEquirect.value=e;let o=new An(s,r),a=e.minFilter;return e.minFilter===ks&&(e.minFilter=Ti),new rc(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();
for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},nr=class extends Tn{constructor(){super(),this.isGroup=!0,this.type="Group"}},$y={type:"move"},lo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new nr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.
inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new nr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new nr,
this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){
let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,
l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let m=e.getJointPose(v,n),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["th\
umb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.
fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&
(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent($y)))}return a!==null&&(a.visible=s!==null),l!==
null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new nr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}};var pa=class extends Tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new fi,this.environmentIntensity=1,this.environmentRotation=new fi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",
{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,
this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=
this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var ac=class extends qn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Xn,u=Xn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var co=class extends Ln{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},eo=new de,Zp=new de,zl=[],Jp=new Gi,Zy=new de,na=new An,ia=new cs,ma=class extends An{constructor(t,e,n){
super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new co(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Zy)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Gi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.
makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,eo),Jp.copy(t.boundingBox).applyMatrix4(eo),this.boundingBox.union(Jp)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new cs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,eo),ia.copy(t.boundingSphere).applyMatrix4(
eo),this.boundingSphere.union(ia)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),t.morphTexture!==null&&(this.morphTexture=t.morphTexture.clone()),t.instanceColor!==null&&(this.instanceColor=t.instanceColor.clone()),this.count=t.count,t.boundingBox!==null&&(this.boundingBox=t.boundingBox.clone()),t.boundingSphere!==null&&(this.boundingSphere=t.boundingSphere.clone()),this}getColorAt(t,e){
e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(na.geometry=this.geometry,na.material=this.material,na.material!==void 0&&(this.boundingSphere===null&&
this.computeBoundingSphere(),ia.copy(this.boundingSphere),ia.applyMatrix4(n),t.ray.intersectsSphere(ia)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,eo),Zp.multiplyMatrices(n,eo),na.matrixWorld=Zp,na.raycast(t,zl);for(let o=0,a=zl.length;o<a;o++){let l=zl[o];l.instanceId=r,l.object=this,e.push(l)}zl.length=0}}setColorAt(t,e){this.instanceColor===null&&(this.instanceColor=new co(new Float32Array(this.
instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3)}setMatrixAt(t,e){e.toArray(this.instanceMatrix.array,t*16)}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new ac(new Float32Array(s*this.count),s,this.count,Nc,Ri));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?
1:1-o,l=s*t;r[l]=a,r.set(n,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},qu=new H,Jy=new H,Ky=new le,Vi=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(
t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=qu.subVectors(n,e).cross(Jy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.
multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(qu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(
t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(
-this.constant)}applyMatrix4(t,e){let n=e||Ky.getNormalMatrix(t),s=this.coplanarPoint(qu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},tr=new cs,jy=new ge(.5,.5),Vl=new H,
ho=class{constructor(t=new Vi,e=new Vi,n=new Vi,s=new Vi,r=new Vi,o=new Vi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ei,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],
u=r[4],h=r[5],f=r[6],d=r[7],g=r[8],v=r[9],m=r[10],p=r[11],b=r[12],T=r[13],_=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,p-g,C-b).normalize(),s[1].setComponents(c+o,d+u,p+g,C+b).normalize(),s[2].setComponents(c+a,d+h,p+v,C+T).normalize(),s[3].setComponents(c-a,d-h,p-v,C-T).normalize(),n)s[4].setComponents(l,f,m,_).normalize(),s[5].setComponents(c-l,d-f,p-m,C-_).normalize();else if(s[4].setComponents(
c-l,d-f,p-m,C-_).normalize(),e===Ei)s[5].setComponents(c+l,d+f,p+m,C+_).normalize();else if(e===aa)s[5].setComponents(l,f,m,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),tr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{
let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),tr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(tr)}intersectsSprite(t){tr.center.set(0,0,0);let e=jy.distanceTo(t.center);return tr.radius=.7071067811865476+e,tr.applyMatrix4(t.matrixWorld),this.intersectsSphere(tr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)
if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Vl.x=s.normal.x>0?t.max.x:t.min.x,Vl.y=s.normal.y>0?t.max.y:t.min.y,Vl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Vl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().
copy(this)}};var uo=class extends Wi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},
lc=new H,cc=new H,Kp=new de,sa=new oo,Hl=new cs,Yu=new H,jp=new H,ar=class extends Tn{constructor(t=new Qe,e=new uo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=
t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new pe(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){
let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(s),Hl.radius+=r,t.ray.intersectsSphere(Hl)===!1)return;Kp.copy(s).invert(),sa.copy(t.ray).applyMatrix4(Kp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;
if(u!==null){let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){let p=u.getX(v),b=u.getX(v+1),T=Gl(this,t,sa,l,p,b,v);T&&e.push(T)}if(this.isLineLoop){let v=u.getX(g-1),m=u.getX(d),p=Gl(this,t,sa,l,v,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){let p=Gl(this,t,sa,l,v,v+1,v);p&&e.push(p)}if(this.
isLineLoop){let v=Gl(this,t,sa,l,g-1,d,g-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Gl(i,t,e,n,s,r,o){let a=i.
geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,Yu,jp)>n)return;Yu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Yu);if(!(c<t.near||c>t.far))return{distance:c,point:jp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Qp=new H,tm=new H,lr=class extends ar{constructor(t,e){
super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Qp.fromBufferAttribute(e,s),tm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Qp.distanceTo(tm);t.setAttribute("lineDistance",new pe(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Co\
mputation only possible with non-indexed BufferGeometry.");return this}},ga=class extends ar{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var va=class extends qn{constructor(t,e,n=zs,s,r,o,a=Xn,l=Xn,c,u=io,h=1){if(u!==io&&u!==Mo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ro(Object.assign({},
t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},ya=class extends qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},xa=class i extends Qe{constructor(t=1,e=1,n=4,s=8,r=1){super(),this.
type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:n,radialSegments:s,heightSegments:r},e=Math.max(0,e),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,f=e,d=2*h+f,g=n*2+r,v=s+1,m=new H,p=new H;for(let b=0;b<=g;b++){let T=0,_=0,C=0,A=0;if(b<=n){let w=b/n,S=w*Math.PI/2;_=-u-t*Math.cos(S),C=t*Math.sin(
S),A=-t*Math.cos(S),T=w*h}else if(b<=n+r){let w=(b-n)/r;_=-u+w*e,C=t,A=0,T=h+w*f}else{let w=(b-n-r)/n,S=w*Math.PI/2;_=u+t*Math.sin(S),C=t*Math.cos(S),A=t*Math.sin(S),T=h+f+w*h}let D=Math.max(0,Math.min(1,T/d)),F=0;b===0?F=.5/s:b===g&&(F=-.5/s);for(let w=0;w<=s;w++){let S=w/s,R=S*Math.PI*2,O=Math.sin(R),z=Math.cos(R);p.x=-C*z,p.y=_,p.z=C*O,a.push(p.x,p.y,p.z),m.set(-C*z,A,C*O),m.normalize(),l.push(
m.x,m.y,m.z),c.push(S+F,D)}if(b>0){let w=(b-1)*v;for(let S=0;S<s;S++){let R=w+S,O=w+S+1,z=b*v+S,W=b*v+S+1;o.push(R,O,z),o.push(O,W,z)}}}this.setIndex(o),this.setAttribute("position",new pe(a,3)),this.setAttribute("normal",new pe(l,3)),this.setAttribute("uv",new pe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.height,
t.capSegments,t.radialSegments,t.heightSegments)}};var fo=class i extends Qe{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],g=0,v=[],m=n/2,p=0;b(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute(
"position",new pe(h,3)),this.setAttribute("normal",new pe(f,3)),this.setAttribute("uv",new pe(d,2));function b(){let _=new H,C=new H,A=0,D=(e-t)/n;for(let F=0;F<=r;F++){let w=[],S=F/r,R=S*(e-t)+t;for(let O=0;O<=s;O++){let z=O/s,W=z*l+a,X=Math.sin(W),q=Math.cos(W);C.x=R*X,C.y=-S*n+m,C.z=R*q,h.push(C.x,C.y,C.z),_.set(X,D,q).normalize(),f.push(_.x,_.y,_.z),d.push(z,1-S),w.push(g++)}v.push(w)}for(let F=0;F<
s;F++)for(let w=0;w<r;w++){let S=v[w][F],R=v[w+1][F],O=v[w+1][F+1],z=v[w][F+1];(t>0||w!==0)&&(u.push(S,R,z),A+=3),(e>0||w!==r-1)&&(u.push(R,O,z),A+=3)}c.addGroup(p,A,0),p+=A}function T(_){let C=g,A=new ge,D=new H,F=0,w=_===!0?t:e,S=_===!0?1:-1;for(let O=1;O<=s;O++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;let R=g;for(let O=0;O<=s;O++){let W=O/s*l+a,X=Math.cos(W),q=Math.sin(W);D.x=w*q,D.y=m*S,
D.z=w*X,h.push(D.x,D.y,D.z),f.push(0,S,0),A.x=X*.5+.5,A.y=q*.5*S+.5,d.push(A.x,A.y),g++}for(let O=0;O<s;O++){let z=C+O,W=R+O;_===!0?u.push(W,W+1,z):u.push(W+1,W,z),F+=3}c.addGroup(p,F,_===!0?1:2),p+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,
t.thetaLength)}},_a=class i extends fo{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Wl=new H,Xl=new H,$u=new H,ql=new rs,po=class extends Qe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Zl*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(
g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:v,b:m,c:p}=ql;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),ql.getNormal($u),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||
h[2]===h[0]))for(let b=0;b<3;b++){let T=(b+1)%3,_=h[b],C=h[T],A=ql[u[b]],D=ql[u[T]],F=`${_}_${C}`,w=`${C}_${_}`;w in f&&f[w]?($u.dot(f[w].normal)<=r&&(d.push(A.x,A.y,A.z),d.push(D.x,D.y,D.z)),f[w]=null):F in f||(f[F]={index0:c[b],index1:c[T],normal:$u.clone()})}}for(let g in f)if(f[g]){let{index0:v,index1:m}=f[g];Wl.fromBufferAttribute(a,v),Xl.fromBufferAttribute(a,m),d.push(Wl.x,Wl.y,Wl.z),d.push(
Xl.x,Xl.y,Xl.z)}this.setAttribute("position",new pe(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var ba=class i extends Qe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){let b=p*f-o;for(let T=0;T<c;T++){let _=T*h-r;g.push(_,-b,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let b=0;b<
a;b++){let T=b+c*p,_=b+c*(p+1),C=b+1+c*(p+1),A=b+1+c*p;d.push(T,_,A),d.push(_,C,A)}this.setIndex(d),this.setAttribute("position",new pe(g,3)),this.setAttribute("normal",new pe(v,3)),this.setAttribute("uv",new pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var mo=class i extends Qe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,f=new H,d=[],g=[],v=[],m=[];for(let p=0;p<=n;p++){let b=[],T=p/n,_=0;p===
0&&o===0?_=.5/e:p===n&&l===Math.PI&&(_=-.5/e);for(let C=0;C<=e;C++){let A=C/e;h.x=-t*Math.cos(s+A*r)*Math.sin(o+T*a),h.y=t*Math.cos(o+T*a),h.z=t*Math.sin(s+A*r)*Math.sin(o+T*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(A+_,1-T),b.push(c++)}u.push(b)}for(let p=0;p<n;p++)for(let b=0;b<e;b++){let T=u[p][b+1],_=u[p][b],C=u[p+1][b],A=u[p+1][b+1];(p!==0||o>0)&&d.push(T,_,A),(p!==
n-1||l<Math.PI)&&d.push(_,C,A)}this.setIndex(d),this.setAttribute("position",new pe(g,3)),this.setAttribute("normal",new pe(v,3)),this.setAttribute("uv",new pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ma=class i extends Qe{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new H,h=new H,f=new H;for(let d=0;d<=n;d++)for(let g=0;g<=s;g++){let v=g/s*r,m=d/n*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.
z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/n)}for(let d=1;d<=n;d++)for(let g=1;g<=s;g++){let v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,b=(s+1)*d+g;o.push(v,m,b),o.push(m,p,b)}this.setIndex(o),this.setAttribute("position",new pe(a,3)),this.setAttribute("normal",new pe(l,3)),this.setAttribute("u\
v",new pe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}};var go=class extends Wi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ce(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=
1,this.normalMap=null,this.normalMapType=ph,this.normalScale=new ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=
!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,
this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.
copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var cr=class extends Wi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ph,this.normalScale=new ge(
1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fi,this.combine=yo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.
copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.
copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},hc=class extends Wi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Fm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=
!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},uc=class extends Wi{constructor(t){super(),this.isMeshDistanceMaterial=
!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Yl(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Qy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var hr=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=
n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(
0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstra\
ct method")}intervalChanged_(){}},fc=class extends hr{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ju,endingEnd:Ju}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ku:r=t,a=2*e-n;break;case ju:r=s.length-
2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Ku:o=t,l=2*n-e;break;case ju:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,
h=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),v=g*g,m=v*g,p=-f*m+2*f*v-f*g,b=(1+f)*m+(-1.5-2*f)*v+(-.5+f)*g+1,T=(-1-d)*m+(1.5+d)*v+.5*g,_=d*m-d*v;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+b*o[c+C]+T*o[l+C]+_*o[h+C];return r}},dc=class extends hr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-
e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},pc=class extends hr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ei=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.
times=Yl(e,this.TimeBufferType),this.values=Yl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Yl(t.times,Array),values:Yl(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){
return new pc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new fc(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case ra:e=this.InterpolantFactoryMethodDiscrete;break;case tc:e=this.InterpolantFactoryMethodLinear;break;case $l:e=
this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.
createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ra;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return $l}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}
return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);
let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Qy(s))
for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===$l,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let g=0;g!==
n;++g){let v=e[h+g];if(v!==e[f+g]||v!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(
this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};ei.prototype.ValueTypeName="";ei.prototype.TimeBufferType=Float32Array;ei.prototype.ValueBufferType=Float32Array;ei.prototype.DefaultInterpolation=tc;var Os=class extends ei{constructor(t,e,n){super(t,e,n)}};Os.prototype.ValueTypeName="bool";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=ra;Os.prototype.InterpolantFactoryMethodLinear=
void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var mc=class extends ei{constructor(t,e,n,s){super(t,e,n,s)}};mc.prototype.ValueTypeName="color";var gc=class extends ei{constructor(t,e,n,s){super(t,e,n,s)}};gc.prototype.ValueTypeName="number";var vc=class extends hr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-
e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Sa=class extends ei{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new vc(this.times,this.values,this.getValueSize(),t)}};Sa.prototype.ValueTypeName="quaternion";Sa.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends ei{constructor(t,e,n){super(t,e,n)}};Bs.prototype.ValueTypeName=
"string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=ra;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var yc=class extends ei{constructor(t,e,n,s){super(t,e,n,s)}};yc.prototype.ValueTypeName="vector";var xc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==
void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],g=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.
abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Zm=new xc,_c=class{constructor(t){this.manager=t!==void 0?t:Zm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=
t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};_c.DEFAULT_MATERIAL_NAME="__DEFAULT";var vo=class extends Tn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),
this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},wa=class extends vo{constructor(t,e,n){super(t,n),this.isHemisphereLight=
!0,this.type="HemisphereLight",this.position.copy(Tn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ce(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}},Zu=new de,em=new H,nm=new H,ef=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ge(512,512),this.mapType=Ci,this.map=null,this.mapPass=
null,this.matrix=new de,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ho,this._frameExtents=new ge(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera,n=this.matrix;em.setFromMatrixPosition(t.matrixWorld),e.position.copy(em),nm.setFromMatrixPosition(t.target.matrixWorld),
e.lookAt(nm),e.updateMatrixWorld(),Zu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Zu,e.coordinateSystem,e.reversedDepth),e.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Zu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.
map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return this.intensity!==
1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}};var ur=class extends fa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,
this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.
view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.
zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.
top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},nf=class extends ef{constructor(){super(new ur(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ea=class extends vo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Tn.DEFAULT_UP),this.updateMatrix(),
this.target=new Tn,this.shadow=new nf}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}},Ta=class extends vo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var bc=class extends In{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var Sf="\\[\\]\\.:\\/",tx=new RegExp("["+Sf+"]","g"),wf="[^"+Sf+"]",ex="[^"+Sf.replace("\\.","")+"]",nx=/((?:WC+[\/:])*)/.source.replace("WC",wf),ix=/(WCOD+)?/.source.replace("WCOD",ex),sx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",wf),rx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",wf),ox=new RegExp("^"+nx+ix+sx+rx+"$"),ax=["material","materials","bones","map"],sf=class{constructor(t,e,n){let s=n||
Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)
t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ze=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.
Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(tx,"")}static parseTrackName(t){let e=ox.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(
s+1);ax.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){
let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){
t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=
!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=
!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(
t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.
objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bi\
nd to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.
bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:
if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+
c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geo\
metry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.
HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=sf;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,
HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],
[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var yT=new Float32Array(1);var im=new de,Aa=class{constructor(t,e,n=0,s=1/0){this.ray=new oo(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).
normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return im.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.
ray.direction.set(0,0,-1).applyMatrix4(im),this}intersectObject(t,e=!0,n=[]){return rf(t,this,n,e),n.sort(sm),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)rf(t[s],this,n,e);return n.sort(sm),n}};function sm(i,t){return i.distance-t.distance}function rf(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<
a;o++)rf(r[o],t,e,!0)}}function Ef(i,t,e,n){let s=lx(n);switch(e){case gf:return i*t;case Nc:return i*t/s.components*s.byteLength;case Oc:return i*t/s.components*s.byteLength;case yf:return i*t*2/s.components*s.byteLength;case Bc:return i*t*2/s.components*s.byteLength;case vf:return i*t*3/s.components*s.byteLength;case pi:return i*t*4/s.components*s.byteLength;case kc:return i*t*4/s.components*s.byteLength;case Pa:case Ia:
return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case La:case Da:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Vc:case Gc:return Math.max(i,16)*Math.max(t,8)/4;case zc:case Hc:return Math.max(i,8)*Math.max(t,8)/2;case Wc:case Xc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case qc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Yc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*
16;case $c:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Zc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case jc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case th:return Math.floor((i+7)/8)*Math.floor((t+
7)/8)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case nh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case ih:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case sh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case rh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case oh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case ah:case lh:case ch:return Math.
ceil(i/4)*Math.ceil(t/4)*16;case hh:case uh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case fh:case dh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function lx(i){switch(i){case Ci:case ff:return{byteLength:1,components:1};case xo:case df:case _o:return{byteLength:2,components:1};case Uc:case Fc:return{byteLength:2,components:4};case zs:case Dc:case Ri:
return{byteLength:4,components:1};case pf:case mf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function xg(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function mx(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(
l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof
Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{
h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){let g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){let v=h[d];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),
t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<
a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,yx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_x=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Mx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Sx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Ex=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Tx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ax=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Cx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Rx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Px=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ix=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Lx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Dx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ux=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Fx=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Nx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Ox=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Bx=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,kx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,zx=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,Vx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,Hx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Gx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Wx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Xx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Yx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$x=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,Zx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Jx=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Kx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,jx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Qx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,t_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,e_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,n_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,i_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,s_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,r_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,o_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,a_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,l_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,c_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,h_=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,u_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,f_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,d_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,p_=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,m_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,g_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,v_=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,y_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,x_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,__=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,b_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,M_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,S_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,w_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,E_=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,T_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,A_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,C_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,R_=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,P_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,I_=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,L_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,D_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,U_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,F_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,N_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,O_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,B_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,k_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,z_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,V_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,H_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,G_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,W_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,X_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,q_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Y_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Z_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,J_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,K_=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,j_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Q_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,tb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,eb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ib=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,rb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ob=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ab=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,cb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,hb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ub=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,db=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,pb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,yb=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_b=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Mb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Sb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,wb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Tb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ab=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Cb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Rb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Pb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ib=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Lb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Db=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Ub=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Fb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Nb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Ob=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Bb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,zb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Hb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Gb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Wb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Xb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Yb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$b=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ue={alphahash_fragment:gx,alphahash_pars_fragment:vx,alphamap_fragment:yx,alphamap_pars_fragment:xx,alphatest_fragment:_x,alphatest_pars_fragment:bx,aomap_fragment:Mx,aomap_pars_fragment:Sx,batching_pars_vertex:wx,batching_vertex:Ex,begin_vertex:Tx,beginnormal_vertex:Ax,bsdfs:Cx,iridescence_fragment:Rx,bumpmap_pars_fragment:Px,clipping_planes_fragment:Ix,clipping_planes_pars_fragment:Lx,clipping_planes_pars_vertex:Dx,
clipping_planes_vertex:Ux,color_fragment:Fx,color_pars_fragment:Nx,color_pars_vertex:Ox,color_vertex:Bx,common:kx,cube_uv_reflection_fragment:zx,defaultnormal_vertex:Vx,displacementmap_pars_vertex:Hx,displacementmap_vertex:Gx,emissivemap_fragment:Wx,emissivemap_pars_fragment:Xx,colorspace_fragment:qx,colorspace_pars_fragment:Yx,envmap_fragment:$x,envmap_common_pars_fragment:Zx,envmap_pars_fragment:Jx,
envmap_pars_vertex:Kx,envmap_physical_pars_fragment:l_,envmap_vertex:jx,fog_vertex:Qx,fog_pars_vertex:t_,fog_fragment:e_,fog_pars_fragment:n_,gradientmap_pars_fragment:i_,lightmap_pars_fragment:s_,lights_lambert_fragment:r_,lights_lambert_pars_fragment:o_,lights_pars_begin:a_,lights_toon_fragment:c_,lights_toon_pars_fragment:h_,lights_phong_fragment:u_,lights_phong_pars_fragment:f_,lights_physical_fragment:d_,
lights_physical_pars_fragment:p_,lights_fragment_begin:m_,lights_fragment_maps:g_,lights_fragment_end:v_,logdepthbuf_fragment:y_,logdepthbuf_pars_fragment:x_,logdepthbuf_pars_vertex:__,logdepthbuf_vertex:b_,map_fragment:M_,map_pars_fragment:S_,map_particle_fragment:w_,map_particle_pars_fragment:E_,metalnessmap_fragment:T_,metalnessmap_pars_fragment:A_,morphinstance_vertex:C_,morphcolor_vertex:R_,morphnormal_vertex:P_,
morphtarget_pars_vertex:I_,morphtarget_vertex:L_,normal_fragment_begin:D_,normal_fragment_maps:U_,normal_pars_fragment:F_,normal_pars_vertex:N_,normal_vertex:O_,normalmap_pars_fragment:B_,clearcoat_normal_fragment_begin:k_,clearcoat_normal_fragment_maps:z_,clearcoat_pars_fragment:V_,iridescence_pars_fragment:H_,opaque_fragment:G_,packing:W_,premultiplied_alpha_fragment:X_,project_vertex:q_,dithering_fragment:Y_,
dithering_pars_fragment:$_,roughnessmap_fragment:Z_,roughnessmap_pars_fragment:J_,shadowmap_pars_fragment:K_,shadowmap_pars_vertex:j_,shadowmap_vertex:Q_,shadowmask_pars_fragment:tb,skinbase_vertex:eb,skinning_pars_vertex:nb,skinning_vertex:ib,skinnormal_vertex:sb,specularmap_fragment:rb,specularmap_pars_fragment:ob,tonemapping_fragment:ab,tonemapping_pars_fragment:lb,transmission_fragment:cb,transmission_pars_fragment:hb,
uv_pars_fragment:ub,uv_pars_vertex:fb,uv_vertex:db,worldpos_vertex:pb,background_vert:mb,background_frag:gb,backgroundCube_vert:vb,backgroundCube_frag:yb,cube_vert:xb,cube_frag:_b,depth_vert:bb,depth_frag:Mb,distanceRGBA_vert:Sb,distanceRGBA_frag:wb,equirect_vert:Eb,equirect_frag:Tb,linedashed_vert:Ab,linedashed_frag:Cb,meshbasic_vert:Rb,meshbasic_frag:Pb,meshlambert_vert:Ib,meshlambert_frag:Lb,meshmatcap_vert:Db,
meshmatcap_frag:Ub,meshnormal_vert:Fb,meshnormal_frag:Nb,meshphong_vert:Ob,meshphong_frag:Bb,meshphysical_vert:kb,meshphysical_frag:zb,meshtoon_vert:Vb,meshtoon_frag:Hb,points_vert:Gb,points_frag:Wb,shadow_vert:Xb,shadow_frag:qb,sprite_vert:Yb,sprite_frag:$b},Tt={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{
value:new le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new le}},envmap:{envMap:{value:null},envMapRotation:{value:new le},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},
lightMapTransform:{value:new le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new le},normalScale:{value:new ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{
value:new le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{
direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},
shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},
pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{
value:0},uvTransform:{value:new le}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}}},qi={basic:{uniforms:Dn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.
meshbasic_frag},lambert:{uniforms:Dn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new ce(0)}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Dn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,
Tt.fog,Tt.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Dn([Tt.common,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.roughnessmap,Tt.metalnessmap,Tt.fog,Tt.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},
envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Dn([Tt.common,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.gradientmap,Tt.fog,Tt.lights,{emissive:{value:new ce(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Dn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,
Tt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Dn([Tt.points,Tt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Dn([Tt.common,Tt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Dn([Tt.common,Tt.displacementmap]),
vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Dn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Dn([Tt.sprite,Tt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new le},t2D:{value:null},backgroundIntensity:{
value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new le}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.
cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distanceRGBA:{uniforms:Dn([Tt.common,Tt.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distanceRGBA_vert,fragmentShader:ue.distanceRGBA_frag},shadow:{uniforms:Dn([Tt.lights,Tt.fog,{color:{
value:new ce(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};qi.physical={uniforms:Dn([qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new le},clearcoatNormalScale:{value:new ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},
clearcoatRoughnessMapTransform:{value:new le},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new le},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{
value:null},sheenColorMapTransform:{value:new le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new le},transmissionSamplerSize:{value:new ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new le},attenuationDistance:{
value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new le},anisotropyVector:{value:new ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new le}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.
meshphysical_frag};var mh={r:0,b:0,g:0},mr=new fi,Zb=new de;function Jb(i,t,e,n,s,r,o){let a=new ce(0),l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(T){let _=T.isScene===!0?T.background:null;return _&&_.isTexture&&(_=(T.backgroundBlurriness>0?e:t).get(_)),_}function v(T){let _=!1,C=g(T);C===null?p(a,l):C&&C.isColor&&(p(C,1),_=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?n.buffers.color.
setClear(0,0,0,1,o):A==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||_)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(T,_){let C=g(_);C&&(C.isCubeTexture||C.mapping===Ca)?(u===void 0&&(u=new An(new hs(1,1,1),new Ai({name:"BackgroundCubeMaterial",uniforms:pr(qi.backgroundCube.
uniforms),vertexShader:qi.backgroundCube.vertexShader,fragmentShader:qi.backgroundCube.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(A,D,F){this.matrixWorld.copyPosition(F.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),
s.update(u)),mr.copy(_.backgroundRotation),mr.x*=-1,mr.y*=-1,mr.z*=-1,C.isCubeTexture&&C.isRenderTargetTexture===!1&&(mr.y*=-1,mr.z*=-1),u.material.uniforms.envMap.value=C,u.material.uniforms.flipEnvMap.value=C.isCubeTexture&&C.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,u.
material.uniforms.backgroundRotation.value.setFromMatrix4(Zb.makeRotationFromEuler(mr)),u.material.toneMapped=_e.getTransfer(C.colorSpace)!==De,(h!==C||f!==C.version||d!==i.toneMapping)&&(u.material.needsUpdate=!0,h=C,f=C.version,d=i.toneMapping),u.layers.enableAll(),T.unshift(u,u.geometry,u.material,0,0,null)):C&&C.isTexture&&(c===void 0&&(c=new An(new ba(2,2),new Ai({name:"BackgroundMaterial",uniforms:pr(
qi.background.uniforms),vertexShader:qi.background.vertexShader,fragmentShader:qi.background.fragmentShader,side:as,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=C,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,
c.material.toneMapped=_e.getTransfer(C.colorSpace)!==De,C.matrixAutoUpdate===!0&&C.updateMatrix(),c.material.uniforms.uvTransform.value.copy(C.matrix),(h!==C||f!==C.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=C,f=C.version,d=i.toneMapping),c.layers.enableAll(),T.unshift(c,c.geometry,c.material,0,0,null))}function p(T,_){T.getRGB(mh,Mf(i)),n.buffers.color.setClear(mh.r,mh.g,mh.b,_,o)}
function b(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(T,_=1){a.set(T),l=_,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(T){l=T,p(a,l)},render:v,addToRenderList:m,dispose:b}}function Kb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),
n={},s=f(null),r=s,o=!1;function a(S,R,O,z,W){let X=!1,q=h(z,O,R);r!==q&&(r=q,c(r.object)),X=d(S,z,O,W),X&&g(S,z,O,W),W!==null&&t.update(W,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,_(S,R,O,z),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function u(S){return i.deleteVertexArray(S)}function h(S,R,O){let z=O.
wireframe===!0,W=n[S.id];W===void 0&&(W={},n[S.id]=W);let X=W[R.id];X===void 0&&(X={},W[R.id]=X);let q=X[z];return q===void 0&&(q=f(l()),X[z]=q),q}function f(S){let R=[],O=[],z=[];for(let W=0;W<e;W++)R[W]=0,O[W]=0,z[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:O,attributeDivisors:z,object:S,attributes:{},index:null}}function d(S,R,O,z){let W=r.attributes,X=R.
attributes,q=0,Z=O.getAttributes();for(let j in Z)if(Z[j].location>=0){let ot=W[j],vt=X[j];if(vt===void 0&&(j==="instanceMatrix"&&S.instanceMatrix&&(vt=S.instanceMatrix),j==="instanceColor"&&S.instanceColor&&(vt=S.instanceColor)),ot===void 0||ot.attribute!==vt||vt&&ot.data!==vt.data)return!0;q++}return r.attributesNum!==q||r.index!==z}function g(S,R,O,z){let W={},X=R.attributes,q=0,Z=O.getAttributes();
for(let j in Z)if(Z[j].location>=0){let ot=X[j];ot===void 0&&(j==="instanceMatrix"&&S.instanceMatrix&&(ot=S.instanceMatrix),j==="instanceColor"&&S.instanceColor&&(ot=S.instanceColor));let vt={};vt.attribute=ot,ot&&ot.data&&(vt.data=ot.data),W[j]=vt,q++}r.attributes=W,r.attributesNum=q,r.index=z}function v(){let S=r.newAttributes;for(let R=0,O=S.length;R<O;R++)S[R]=0}function m(S){p(S,0)}function p(S,R){
let O=r.newAttributes,z=r.enabledAttributes,W=r.attributeDivisors;O[S]=1,z[S]===0&&(i.enableVertexAttribArray(S),z[S]=1),W[S]!==R&&(i.vertexAttribDivisor(S,R),W[S]=R)}function b(){let S=r.newAttributes,R=r.enabledAttributes;for(let O=0,z=R.length;O<z;O++)R[O]!==S[O]&&(i.disableVertexAttribArray(O),R[O]=0)}function T(S,R,O,z,W,X,q){q===!0?i.vertexAttribIPointer(S,R,O,W,X):i.vertexAttribPointer(S,R,
O,z,W,X)}function _(S,R,O,z){v();let W=z.attributes,X=O.getAttributes(),q=R.defaultAttributeValues;for(let Z in X){let j=X[Z];if(j.location>=0){let rt=W[Z];if(rt===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(rt=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(rt=S.instanceColor)),rt!==void 0){let ot=rt.normalized,vt=rt.itemSize,bt=t.get(rt);if(bt===void 0)continue;let pt=bt.buffer,se=bt.
type,Kt=bt.bytesPerElement,Q=se===i.INT||se===i.UNSIGNED_INT||rt.gpuType===Dc;if(rt.isInterleavedBufferAttribute){let tt=rt.data,wt=tt.stride,zt=rt.offset;if(tt.isInstancedInterleavedBuffer){for(let xt=0;xt<j.locationSize;xt++)p(j.location+xt,tt.meshPerAttribute);S.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let xt=0;xt<j.locationSize;xt++)
m(j.location+xt);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let xt=0;xt<j.locationSize;xt++)T(j.location+xt,vt/j.locationSize,se,ot,wt*Kt,(zt+vt/j.locationSize*xt)*Kt,Q)}else{if(rt.isInstancedBufferAttribute){for(let tt=0;tt<j.locationSize;tt++)p(j.location+tt,rt.meshPerAttribute);S.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=rt.meshPerAttribute*rt.count)}else for(let tt=0;tt<
j.locationSize;tt++)m(j.location+tt);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let tt=0;tt<j.locationSize;tt++)T(j.location+tt,vt/j.locationSize,se,ot,vt*Kt,vt/j.locationSize*tt*Kt,Q)}}else if(q!==void 0){let ot=q[Z];if(ot!==void 0)switch(ot.length){case 2:i.vertexAttrib2fv(j.location,ot);break;case 3:i.vertexAttrib3fv(j.location,ot);break;case 4:i.vertexAttrib4fv(j.location,ot);break;default:i.vertexAttrib1fv(
j.location,ot)}}}}b()}function C(){F();for(let S in n){let R=n[S];for(let O in R){let z=R[O];for(let W in z)u(z[W].object),delete z[W];delete R[O]}delete n[S]}}function A(S){if(n[S.id]===void 0)return;let R=n[S.id];for(let O in R){let z=R[O];for(let W in z)u(z[W].object),delete z[W];delete R[O]}delete n[S.id]}function D(S){for(let R in n){let O=n[R];if(O[S.id]===void 0)continue;let z=O[S.id];for(let W in z)
u(z[W].object),delete z[W];delete O[S.id]}}function F(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:w,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:b}}function jb(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(
u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,n,1)}function l(c,u,h,f){if(h===0)return;let d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,
0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Qb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){
return!(D!==pi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let F=D===_o&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Ci&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Ri&&!F)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(
i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.
logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(
i.MAX_FRAGMENT_UNIFORM_VECTORS),C=g>0,A=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:b,maxVaryings:T,maxFragmentUniforms:_,vertexTextures:C,maxSamples:A}}
function tM(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Vi,a=new le,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let g=h.clippingPlanes,
v=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let b=r?0:n,T=b*4,_=p.clippingState||null;l.value=_,_=u(g,f,T,d);for(let C=0;C!==T;++C)_[C]=e[C];p.clippingState=_,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,g){let v=h!==null?
h.length:0,m=null;if(v!==0){if(m=l.value,g!==!0||m===null){let p=d+v*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,_=d;T!==v;++T,_+=4)o.copy(h[T]).applyMatrix4(b,a),o.normal.toArray(m,_),m[_+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function eM(i){let t=new WeakMap;function e(o,a){return a===Pc?o.
mapping=fr:a===Ic&&(o.mapping=dr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Pc||a===Ic)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new oc(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener(
"dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var wo=4,Jm=[.125,.215,.35,.446,.526,.582],yr=20,Tf=new ur,Km=new ce,Af=null,Cf=0,Rf=0,Pf=!1,vr=(1+Math.sqrt(5))/2,So=1/vr,jm=[new H(-vr,So,0),new H(vr,So,0),new H(-So,0,vr),new H(So,0,vr),new H(0,vr,-So),new H(0,vr,So),new H(-1,1,-1),new H(1,1,-1),new H(-1,1,1),new H(1,1,1)],nM=new H,
yh=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=nM}=r;Af=this._renderer.getRenderTarget(),Cf=this._renderer.getActiveCubeFace(),
Rf=this._renderer.getActiveMipmapLevel(),Pf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,n,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){
this._cubemapMaterial===null&&(this._cubemapMaterial=eg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=tg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){
this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Af,Cf,Rf),this._renderer.xr.enabled=Pf,t.scissorTest=!1,gh(t,0,0,t.width,
t.height)}_fromTexture(t,e){t.mapping===fr||t.mapping===dr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Af=this._renderer.getRenderTarget(),Cf=this._renderer.getActiveCubeFace(),Rf=this._renderer.getActiveMipmapLevel(),Pf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(
t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Ti,minFilter:Ti,generateMipmaps:!1,type:_o,format:pi,colorSpace:rr,depthBuffer:!1},s=Qm(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=
Qm(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=iM(r)),this._blurMaterial=sM(r,t,e)}return s}_compileMaterial(t){let e=new An(this._lodPlanes[0],t);this._renderer.compile(e,Tf)}_sceneToCubeUV(t,e,n,s,r){let l=new In(90,1,e,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(Km),h.toneMapping=fs,
h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new or({name:"PMREM.Background",side:zn,depthWrite:!1,depthTest:!1}),m=new An(new hs,v),p=!1,b=t.background;b?b.isColor&&(v.color.copy(b),t.background=null,p=!0):(v.color.copy(Km),p=!0);for(let T=0;T<6;T++){let _=T%3;_===0?(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(
r.x+u[T],r.y,r.z)):_===1?(l.up.set(0,0,c[T]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[T],r.z)):(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[T]));let C=this._cubeSize;gh(s,_*C,T>2?C:0,C,C),h.setRenderTarget(s),p&&h.render(m,l),h.render(t,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=d,h.autoClear=f,t.background=b}_textureToCubeUV(t,e){let n=this._renderer,
s=t.mapping===fr||t.mapping===dr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=eg()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=tg());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new An(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;gh(e,0,0,3*l,2*l),n.setRenderTarget(
e),n.render(o,Tf)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=jm[(s-r-1)%jm.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"lo\
ngitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new An(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*yr-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):yr;m>yr&&console.warn(`sigmaRadians, ${r}, i\
s too large and will clip, as it requested ${m} samples when the maximum is set to ${yr}`);let p=[],b=0;for(let D=0;D<yr;++D){let F=D/v,w=Math.exp(-F*F/2);p.push(w),D===0?b+=w:D<m&&(b+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/b;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=
T-n;let _=this._sizeLods[s],C=3*_*(s>T-wo?s-T+wo:0),A=4*(this._cubeSize-_);gh(e,C,A,3*_,2*_),l.setRenderTarget(e),l.render(h,Tf)}};function iM(i){let t=[],e=[],n=[],s=i,r=i-wo+1+Jm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-wo?l=Jm[o-i+wo-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,b=new Float32Array(v*g*d),T=new Float32Array(
m*g*d),_=new Float32Array(p*g*d);for(let A=0;A<d;A++){let D=A%3*2/3-1,F=A>2?0:-1,w=[D,F,0,D+2/3,F,0,D+2/3,F+1,0,D,F,0,D+2/3,F+1,0,D,F+1,0];b.set(w,v*g*A),T.set(f,m*g*A);let S=[A,A,A,A,A,A];_.set(S,p*g*A)}let C=new Qe;C.setAttribute("position",new Ln(b,v)),C.setAttribute("uv",new Ln(T,m)),C.setAttribute("faceIndex",new Ln(_,p)),t.push(C),s>wo&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function Qm(i,t,e){
let n=new Hi(i,t,e);return n.texture.mapping=Ca,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function gh(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function sM(i,t,e){let n=new Float32Array(yr),s=new H(0,1,0);return new Ai({name:"SphericalGaussianBlur",defines:{n:yr,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},
weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:us,depthTest:!1,depthWrite:!1})}function tg(){return new Ai({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:us,depthTest:!1,depthWrite:!1})}function eg(){return new Ai({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:us,depthTest:!1,depthWrite:!1})}function zf(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function rM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Pc||l===Ic,u=l===fr||l===dr;if(c||u){let h=t.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new yh(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;
{let d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new yh(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.
delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function oM(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension(
"EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension(
"WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){
let s=e(n);return s===null&&so("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function aM(i,t,e,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&t.remove(f.index);for(let g in f.attributes)t.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let d=r.get(f);d&&(t.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===
!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){let f=h.attributes;for(let d in f)t.update(f[d],i.ARRAY_BUFFER)}function c(h){let f=[],d=h.index,g=h.attributes.position,v=0;if(d!==null){let b=d.array;v=d.version;for(let T=0,_=b.length;T<_;T+=3){let C=b[T+0],A=b[T+1],D=b[T+2];
f.push(C,A,A,D,D,C)}}else if(g!==void 0){let b=g.array;v=g.version;for(let T=0,_=b.length/3-1;T<_;T+=3){let C=T+0,A=T+1,D=T+2;f.push(C,A,A,D,D,C)}}else return;let m=new(bf(f)?ua:ha)(f,1);m.version=v;let p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){let f=r.get(h);if(f){let d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function lM(i,t,e){
let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){i.drawElements(n,d,r,f*o),e.update(d,n,1)}function c(f,d,g){g!==0&&(i.drawElementsInstanced(n,d,r,f*o,g),e.update(d,n,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,n,1)}function h(f,d,g,v){if(g===0)return;let m=t.
get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,v,0,g);let p=0;for(let b=0;b<g;b++)p+=d[b]*v[b];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function cM(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,
points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,
programs:null,autoReset:!0,reset:s,update:n}}function hM(i,t,e){let n=new WeakMap,s=new tn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let w=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.
position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],T=0;d===!0&&(T=1),g===!0&&(T=2),v===!0&&(T=3);let _=a.attributes.position.count*T,C=1;_>t.maxTextureSize&&(C=Math.ceil(_/t.maxTextureSize),_=t.maxTextureSize);let A=new Float32Array(_*C*4*h),D=new ca(A,_,C,h);D.type=Ri,
D.needsUpdate=!0;let F=T*4;for(let S=0;S<h;S++){let R=m[S],O=p[S],z=b[S],W=_*C*4*S;for(let X=0;X<R.count;X++){let q=X*F;d===!0&&(s.fromBufferAttribute(R,X),A[W+q+0]=s.x,A[W+q+1]=s.y,A[W+q+2]=s.z,A[W+q+3]=0),g===!0&&(s.fromBufferAttribute(O,X),A[W+q+4]=s.x,A[W+q+5]=s.y,A[W+q+6]=s.z,A[W+q+7]=0),v===!0&&(s.fromBufferAttribute(z,X),A[W+q+8]=s.x,A[W+q+9]=s.y,A[W+q+10]=s.z,A[W+q+11]=z.itemSize===4?s.w:1)}}
f={count:h,texture:D,size:new ge(_,C)},n.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().
setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function uM(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),
l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var _g=new qn,ng=new va(1,1),bg=new ca,Mg=new sc,
Sg=new da,ig=[],sg=[],rg=new Float32Array(16),og=new Float32Array(9),ag=new Float32Array(4);function To(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=ig[s];if(r===void 0&&(r=new Float32Array(s),ig[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function cn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}
function hn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function _h(i,t){let e=sg[t];e===void 0&&(e=new Int32Array(t),sg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function dM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(
e,t))return;i.uniform2fv(this.addr,t),hn(e,t)}}function pM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(cn(e,t))return;i.uniform3fv(this.addr,t),hn(e,t)}}function mM(i,t){let e=this.
cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4fv(this.addr,t),hn(e,t)}}function gM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;ag.set(n),i.uniformMatrix2fv(this.addr,!1,ag),hn(
e,n)}}function vM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;og.set(n),i.uniformMatrix3fv(this.addr,!1,og),hn(e,n)}}function yM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;rg.set(n),i.uniformMatrix4fv(this.addr,!1,rg),hn(
e,n)}}function xM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function _M(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(e,t))return;i.uniform2iv(this.addr,t),hn(e,t)}}function bM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.
x,e[1]=t.y,e[2]=t.z);else{if(cn(e,t))return;i.uniform3iv(this.addr,t),hn(e,t)}}function MM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4iv(this.addr,t),hn(e,t)}}function SM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function wM(i,t){
let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(e,t))return;i.uniform2uiv(this.addr,t),hn(e,t)}}function EM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(cn(e,t))return;i.uniform3uiv(this.addr,t),hn(e,t)}}function TM(i,t){let e=this.
cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4uiv(this.addr,t),hn(e,t)}}function AM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(ng.compareFunction=xf,r=ng):r=_g,e.setTexture2D(
t||r,s)}function CM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Mg,s)}function RM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Sg,s)}function PM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||bg,
s)}function IM(i){switch(i){case 5126:return fM;case 35664:return dM;case 35665:return pM;case 35666:return mM;case 35674:return gM;case 35675:return vM;case 35676:return yM;case 5124:case 35670:return xM;case 35667:case 35671:return _M;case 35668:case 35672:return bM;case 35669:case 35673:return MM;case 5125:return SM;case 36294:return wM;case 36295:return EM;case 36296:return TM;case 35678:case 36198:case 36298:case 36306:case 35682:
return AM;case 35679:case 36299:case 36307:return CM;case 35680:case 36300:case 36308:case 36293:return RM;case 36289:case 36303:case 36311:case 36292:return PM}}function LM(i,t){i.uniform1fv(this.addr,t)}function DM(i,t){let e=To(t,this.size,2);i.uniform2fv(this.addr,e)}function UM(i,t){let e=To(t,this.size,3);i.uniform3fv(this.addr,e)}function FM(i,t){let e=To(t,this.size,4);i.uniform4fv(this.addr,
e)}function NM(i,t){let e=To(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function OM(i,t){let e=To(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function BM(i,t){let e=To(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function kM(i,t){i.uniform1iv(this.addr,t)}function zM(i,t){i.uniform2iv(this.addr,t)}function VM(i,t){i.uniform3iv(this.addr,t)}function HM(i,t){i.uniform4iv(this.addr,
t)}function GM(i,t){i.uniform1uiv(this.addr,t)}function WM(i,t){i.uniform2uiv(this.addr,t)}function XM(i,t){i.uniform3uiv(this.addr,t)}function qM(i,t){i.uniform4uiv(this.addr,t)}function YM(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||_g,r[o])}function $M(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);cn(n,r)||(i.
uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Mg,r[o])}function ZM(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Sg,r[o])}function JM(i,t,e){let n=this.cache,s=t.length,r=_h(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||bg,r[o])}
function KM(i){switch(i){case 5126:return LM;case 35664:return DM;case 35665:return UM;case 35666:return FM;case 35674:return NM;case 35675:return OM;case 35676:return BM;case 5124:case 35670:return kM;case 35667:case 35671:return zM;case 35668:case 35672:return VM;case 35669:case 35673:return HM;case 5125:return GM;case 36294:return WM;case 36295:return XM;case 36296:return qM;case 35678:case 36198:case 36298:case 36306:case 35682:
return YM;case 35679:case 36299:case 36307:return $M;case 35680:case 36300:case 36308:case 36293:return ZM;case 36289:case 36303:case 36311:case 36292:return JM}}var Lf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=IM(e.type)}},Df=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=KM(e.type)}},Uf=class{constructor(t){
this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},If=/(\w+)(\])?(\[|\.)?/g;function lg(i,t){i.seq.push(t),i.map[t.id]=t}function jM(i,t,e){let n=i.name,s=n.length;for(If.lastIndex=0;;){let r=If.exec(n),o=If.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){lg(e,c===void 0?new Lf(a,
i,t):new Df(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new Uf(a),lg(e,h)),e=h}}}var Eo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);jM(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.
setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function cg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var QM=37297,tS=0;function eS(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var hg=new le;function nS(i){_e._getMatrix(hg,_e.workingColorSpace,i);let t=`mat3( ${hg.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(i)){case oa:return[t,"LinearTransferOETF"];case De:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function ug(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.
getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+eS(i.getShaderSource(t),a)}else return r}function iS(i,t){let e=nS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function sS(i,t){let e;switch(t){case Am:e="Linear";break;case Cm:e="Reinhard";break;case Rm:e="Cineon";break;case Pm:e="ACESFilmic";break;case Lm:e="AgX";break;case Dm:e="Neutral";break;case Im:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var vh=new H;function rS(){_e.getLuminanceCoefficients(
vh);let i=vh.x.toFixed(4),t=vh.y.toFixed(4),e=vh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function oS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function aS(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function lS(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Fa(i){return i!==""}function fg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;
return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,
t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function dg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var cS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ff(i){return i.replace(cS,uS)}var hS=new Map;function uS(i,t){
let e=ue[t];if(e===void 0){let n=hS.get(t);if(n!==void 0)e=ue[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Ff(e)}var fS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function pg(i){return i.
replace(fS,dS)}function dS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function mg(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function pS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===af?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===Mc?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Xi&&(t="SHADOWMAP_TYPE_VSM"),t}function mS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case fr:case dr:t="ENVMAP_TYPE_CUBE";break;case Ca:t="ENVMAP_TYPE_CUBE_UV";break}return t}function gS(i){let t="\
ENVMAP_MODE_REFLECTION";return i.envMap&&i.envMapMode===dr&&(t="ENVMAP_MODE_REFRACTION"),t}function vS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case yo:t="ENVMAP_BLENDING_MULTIPLY";break;case Em:t="ENVMAP_BLENDING_MIX";break;case Tm:t="ENVMAP_BLENDING_ADD";break}return t}function yS(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/
(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function xS(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=pS(e),c=mS(e),u=gS(e),h=vS(e),f=yS(e),d=oS(e),g=aS(r),v=s.createProgram(),m,p,b=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Fa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Fa).join(`
`),p.length>0&&(p+=`
`)):(m=[mg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#defin\
e USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTS\
PACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEM\
AP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",
e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#de\
fine AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?
"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDE\
SCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV\
 "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#defin\
e USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MO\
RPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE\
_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_\
MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined\
( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),p=[mg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_\
TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?
"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCEN\
CE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALP\
HAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?
"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDE\
D":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHM\
IC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==fs?"#define TONE_MAPPING":"",e.toneMapping!==fs?ue.tonemapping_pars_fragment:"",e.toneMapping!==fs?sS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,
iS("linearToOutputTexel",e.outputColorSpace),rS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=Ff(o),o=fg(o,e),o=dg(o,e),a=Ff(a),a=fg(a,e),a=dg(a,e),o=pg(o),a=pg(a),e.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===_f?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===_f?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEX\
T textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let T=b+m+o,_=b+p+a,C=cg(s,s.VERTEX_SHADER,T),A=cg(s,s.FRAGMENT_SHADER,_);s.attachShader(v,C),s.attachShader(v,A),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(R){if(i.debug.checkShaderErrors){let O=s.getProgramInfoLog(v)||"",z=s.getShaderInfoLog(C)||"",W=s.getShaderInfoLog(A)||
"",X=O.trim(),q=z.trim(),Z=W.trim(),j=!0,rt=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,C,A);else{let ot=ug(s,C,"vertex"),vt=ug(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+X+`
`+ot+`
`+vt)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(q===""||Z==="")&&(rt=!1);rt&&(R.diagnostics={runnable:j,programLog:X,vertexShader:{log:q,prefix:m},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(C),s.deleteShader(A),F=new Eo(s,v),w=lS(s,v)}let F;this.getUniforms=function(){return F===void 0&&D(this),F};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.
rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,QM)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=tS++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=C,this.fragmentShader=A,this}var _S=0,Nf=class{constructor(){
this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);
return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(
t);return n===void 0&&(n=new Of(t),e.set(t,n)),n}},Of=class{constructor(t){this.id=_S++,this.code=t,this.usedTimes=0}};function bS(i,t,e,n,s,r,o){let a=new ao,l=new Nf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,d=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"\
phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,S,R,O,z){let W=O.fog,X=z.geometry,q=w.isMeshStandardMaterial?O.environment:null,Z=(w.isMeshStandardMaterial?
e:t).get(w.envMap||q),j=Z&&Z.mapping===Ca?Z.image.height:null,rt=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));let ot=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,vt=ot!==void 0?ot.length:0,bt=0;X.morphAttributes.position!==void 0&&(bt=
1),X.morphAttributes.normal!==void 0&&(bt=2),X.morphAttributes.color!==void 0&&(bt=3);let pt,se,Kt,Q;if(rt){let be=qi[rt];pt=be.vertexShader,se=be.fragmentShader}else pt=w.vertexShader,se=w.fragmentShader,l.update(w),Kt=l.getVertexShaderID(w),Q=l.getFragmentShaderID(w);let tt=i.getRenderTarget(),wt=i.state.buffers.depth.getReversed(),zt=z.isInstancedMesh===!0,xt=z.isBatchedMesh===!0,ne=!!w.map,Pe=!!w.
matcap,U=!!Z,xe=!!w.aoMap,te=!!w.lightMap,Yt=!!w.bumpMap,Ot=!!w.normalMap,Ie=!!w.displacementMap,Lt=!!w.emissiveMap,qt=!!w.metalnessMap,Ge=!!w.roughnessMap,Ee=w.anisotropy>0,I=w.clearcoat>0,x=w.dispersion>0,N=w.iridescence>0,J=w.sheen>0,nt=w.transmission>0,et=Ee&&!!w.anisotropyMap,Bt=I&&!!w.clearcoatMap,ht=I&&!!w.clearcoatNormalMap,Ut=I&&!!w.clearcoatRoughnessMap,Rt=N&&!!w.iridescenceMap,at=N&&!!w.
iridescenceThicknessMap,gt=J&&!!w.sheenColorMap,Gt=J&&!!w.sheenRoughnessMap,Ht=!!w.specularMap,Mt=!!w.specularColorMap,ie=!!w.specularIntensityMap,B=nt&&!!w.transmissionMap,ut=nt&&!!w.thicknessMap,dt=!!w.gradientMap,Dt=!!w.alphaMap,ct=w.alphaTest>0,st=!!w.alphaHash,Vt=!!w.extensions,re=fs;w.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(re=i.toneMapping);let Ue={shaderID:rt,shaderType:w.type,
shaderName:w.name,vertexShader:pt,fragmentShader:se,defines:w.defines,customVertexShaderID:Kt,customFragmentShaderID:Q,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:xt,batchingColor:xt&&z._colorsTexture!==null,instancing:zt,instancingColor:zt&&z.instanceColor!==null,instancingMorph:zt&&z.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:tt===
null?i.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:rr,alphaToCoverage:!!w.alphaToCoverage,map:ne,matcap:Pe,envMap:U,envMapMode:U&&Z.mapping,envMapCubeUVHeight:j,aoMap:xe,lightMap:te,bumpMap:Yt,normalMap:Ot,displacementMap:f&&Ie,emissiveMap:Lt,normalMapObjectSpace:Ot&&w.normalMapType===Om,normalMapTangentSpace:Ot&&w.normalMapType===ph,metalnessMap:qt,roughnessMap:Ge,anisotropy:Ee,
anisotropyMap:et,clearcoat:I,clearcoatMap:Bt,clearcoatNormalMap:ht,clearcoatRoughnessMap:Ut,dispersion:x,iridescence:N,iridescenceMap:Rt,iridescenceThicknessMap:at,sheen:J,sheenColorMap:gt,sheenRoughnessMap:Gt,specularMap:Ht,specularColorMap:Mt,specularIntensityMap:ie,transmission:nt,transmissionMap:B,thicknessMap:ut,gradientMap:dt,opaque:w.transparent===!1&&w.blending===ir&&w.alphaToCoverage===!1,
alphaMap:Dt,alphaTest:ct,alphaHash:st,combine:w.combine,mapUv:ne&&v(w.map.channel),aoMapUv:xe&&v(w.aoMap.channel),lightMapUv:te&&v(w.lightMap.channel),bumpMapUv:Yt&&v(w.bumpMap.channel),normalMapUv:Ot&&v(w.normalMap.channel),displacementMapUv:Ie&&v(w.displacementMap.channel),emissiveMapUv:Lt&&v(w.emissiveMap.channel),metalnessMapUv:qt&&v(w.metalnessMap.channel),roughnessMapUv:Ge&&v(w.roughnessMap.
channel),anisotropyMapUv:et&&v(w.anisotropyMap.channel),clearcoatMapUv:Bt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:ht&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Ut&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:Rt&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:at&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:gt&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:Gt&&
v(w.sheenRoughnessMap.channel),specularMapUv:Ht&&v(w.specularMap.channel),specularColorMapUv:Mt&&v(w.specularColorMap.channel),specularIntensityMapUv:ie&&v(w.specularIntensityMap.channel),transmissionMapUv:B&&v(w.transmissionMap.channel),thicknessMapUv:ut&&v(w.thicknessMap.channel),alphaMapUv:Dt&&v(w.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(Ot||Ee),vertexColors:w.vertexColors,vertexAlphas:w.
vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!X.attributes.uv&&(ne||Dt),fog:!!W,useFog:w.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:w.flatShading===!0&&w.wireframe===!1,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:wt,skinning:z.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.
morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:vt,morphTextureStride:bt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.
length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:re,decodeVideoTexture:ne&&w.map.isVideoTexture===!0&&_e.getTransfer(w.map.colorSpace)===
De,decodeVideoTextureEmissive:Lt&&w.emissiveMap.isVideoTexture===!0&&_e.getTransfer(w.emissiveMap.colorSpace)===De,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===di,flipSided:w.side===zn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Vt&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_dis\
tance"),extensionMultiDraw:(Vt&&w.extensions.multiDraw===!0||xt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return Ue.vertexUv1s=c.has(1),Ue.vertexUv2s=c.has(2),Ue.vertexUv3s=c.has(3),c.clear(),Ue}function p(w){let S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(
w.customFragmentShaderID)),w.defines!==void 0)for(let R in w.defines)S.push(R),S.push(w.defines[R]);return w.isRawShaderMaterial===!1&&(b(S,w),T(S,w),S.push(i.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function b(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),
w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),
w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),
w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(
3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&
a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),
S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}
function _(w){let S=g[w.type],R;if(S){let O=qi[S];R=$m.clone(O.uniforms)}else R=w.uniforms;return R}function C(w,S){let R;for(let O=0,z=u.length;O<z;O++){let W=u[O];if(W.cacheKey===S){R=W,++R.usedTimes;break}}return R===void 0&&(R=new xS(i,S,w,r),u.push(R)),R}function A(w){if(--w.usedTimes===0){let S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function F(){l.dispose()}
return{getParameters:m,getProgramCacheKey:p,getUniforms:_,acquireProgram:C,releaseProgram:A,releaseShaderCache:D,programs:u,dispose:F}}function MS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function SS(i,t){
return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function gg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function vg(){let i=[],t=0,e=[],
n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,d,g,v,m){let p=i[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},i[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){let p=o(h,f,d,g,v,m);d.transmission>0?n.push(p):
d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){let p=o(h,f,d,g,v,m);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||SS),n.length>1&&n.sort(f||gg),s.length>1&&s.sort(f||gg)}function u(){for(let h=t,f=i.length;h<f;h++){let d=i[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}
return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function wS(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new vg,i.set(n,[o])):s>=r.length?(o=new vg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function ES(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"Directi\
onalLight":e={direction:new H,color:new ce};break;case"SpotLight":e={position:new H,direction:new H,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new H,halfWidth:new H,halfHeight:new H};
break}return i[t.id]=e,e}}}function TS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,
shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var AS=0;function CS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function RS(i){let t=new ES,e=TS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,
numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<
9;c++)n.probe.push(new H);let s=new H,r=new de,o=new de;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,b=0,T=0,_=0,C=0,A=0,D=0;c.sort(CS);for(let w=0,S=c.length;w<S;w++){let R=c[w],O=R.color,z=R.intensity,W=R.distance,X=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)u+=O.r*z,h+=O.g*z,f+=O.b*z;else if(R.isLightProbe){for(let q=0;q<
9;q++)n.probe[q].addScaledVector(R.sh.coefficients[q],z);D++}else if(R.isDirectionalLight){let q=t.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Z=R.shadow,j=e.get(R);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,n.directionalShadow[d]=j,n.directionalShadowMap[d]=X,n.directionalShadowMatrix[d]=
R.shadow.matrix,b++}n.directional[d]=q,d++}else if(R.isSpotLight){let q=t.get(R);q.position.setFromMatrixPosition(R.matrixWorld),q.color.copy(O).multiplyScalar(z),q.distance=W,q.coneCos=Math.cos(R.angle),q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),q.decay=R.decay,n.spot[v]=q;let Z=R.shadow;if(R.map&&(n.spotLightMap[C]=R.map,C++,Z.updateMatrices(R),R.castShadow&&A++),n.spotLightMatrix[v]=Z.matrix,
R.castShadow){let j=e.get(R);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,n.spotShadow[v]=j,n.spotShadowMap[v]=X,_++}v++}else if(R.isRectAreaLight){let q=t.get(R);q.color.copy(O).multiplyScalar(z),q.halfWidth.set(R.width*.5,0,0),q.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=q,m++}else if(R.isPointLight){let q=t.
get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),q.distance=R.distance,q.decay=R.decay,R.castShadow){let Z=R.shadow,j=e.get(R);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,j.shadowCameraNear=Z.camera.near,j.shadowCameraFar=Z.camera.far,n.pointShadow[g]=j,n.pointShadowMap[g]=X,n.pointShadowMatrix[g]=R.
shadow.matrix,T++}n.point[g]=q,g++}else if(R.isHemisphereLight){let q=t.get(R);q.skyColor.copy(R.color).multiplyScalar(z),q.groundColor.copy(R.groundColor).multiplyScalar(z),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Tt.LTC_FLOAT_1,n.rectAreaLTC2=Tt.LTC_FLOAT_2):(n.rectAreaLTC1=Tt.LTC_HALF_1,n.rectAreaLTC2=Tt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=
f;let F=n.hash;(F.directionalLength!==d||F.pointLength!==g||F.spotLength!==v||F.rectAreaLength!==m||F.hemiLength!==p||F.numDirectionalShadows!==b||F.numPointShadows!==T||F.numSpotShadows!==_||F.numSpotMaps!==C||F.numLightProbes!==D)&&(n.directional.length=d,n.spot.length=v,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.
length=T,n.pointShadowMap.length=T,n.spotShadow.length=_,n.spotShadowMap.length=_,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=_+C-A,n.spotLightMap.length=C,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=D,F.directionalLength=d,F.pointLength=g,F.spotLength=v,F.rectAreaLength=m,F.hemiLength=p,F.numDirectionalShadows=b,F.numPointShadows=T,F.numSpotShadows=
_,F.numSpotMaps=C,F.numLightProbes=D,n.version=AS++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0,m=u.matrixWorldInverse;for(let p=0,b=c.length;p<b;p++){let T=c[p];if(T.isDirectionalLight){let _=n.directional[h];_.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(m),h++}else if(T.isSpotLight){let _=n.spot[d];_.
position.setFromMatrixPosition(T.matrixWorld),_.position.applyMatrix4(m),_.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(m),d++}else if(T.isRectAreaLight){let _=n.rectArea[g];_.position.setFromMatrixPosition(T.matrixWorld),_.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.
extractRotation(r),_.halfWidth.set(T.width*.5,0,0),_.halfHeight.set(0,T.height*.5,0),_.halfWidth.applyMatrix4(o),_.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){let _=n.point[f];_.position.setFromMatrixPosition(T.matrixWorld),_.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){let _=n.hemi[v];_.direction.setFromMatrixPosition(T.matrixWorld),_.direction.transformDirection(m),v++}}}
return{setup:a,setupView:l,state:n}}function yg(i){let t=new RS(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function PS(i){
let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new yg(i),t.set(s,[a])):r>=o.length?(a=new yg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var IS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,LS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function DS(i,t,e){let n=new ho,s=new ge,r=new ge,o=new tn,a=new hc({depthPacking:Nm}),l=new uc,c={},u=e.maxTextureSize,h={[as]:zn,[zn]:as,[di]:di},f=new Ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ge},radius:{value:4}},vertexShader:IS,fragmentShader:LS}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new Qe;g.setAttribute("position",new Ln(new Float32Array(
[-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new An(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=af;let p=this.type;this.render=function(A,D,F){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;let w=i.getRenderTarget(),S=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),O=i.state;O.setBlending(us),O.buffers.depth.getReversed()===!0?O.buffers.color.
setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=p!==Xi&&this.type===Xi,W=p===Xi&&this.type!==Xi;for(let X=0,q=A.length;X<q;X++){let Z=A[X],j=Z.shadow;if(j===void 0){console.warn("THREE.WebGLShadowMap:",Z,"has no shadow.");continue}if(j.autoUpdate===!1&&j.needsUpdate===!1)continue;s.copy(j.mapSize);let rt=j.getFrameExtents();if(s.multiply(rt),
r.copy(j.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/rt.x),s.x=r.x*rt.x,j.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/rt.y),s.y=r.y*rt.y,j.mapSize.y=r.y)),j.map===null||z===!0||W===!0){let vt=this.type!==Xi?{minFilter:Xn,magFilter:Xn}:{};j.map!==null&&j.map.dispose(),j.map=new Hi(s.x,s.y,vt),j.map.texture.name=Z.name+".shadowMap",j.camera.updateProjectionMatrix()}i.setRenderTarget(j.map),i.clear();
let ot=j.getViewportCount();for(let vt=0;vt<ot;vt++){let bt=j.getViewport(vt);o.set(r.x*bt.x,r.y*bt.y,r.x*bt.z,r.y*bt.w),O.viewport(o),j.updateMatrices(Z,vt),n=j.getFrustum(),_(D,F,j.camera,Z,this.type)}j.isPointLightShadow!==!0&&this.type===Xi&&b(j,F),j.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(w,S,R)};function b(A,D){let F=t.update(v);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.
defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Hi(s.x,s.y)),f.uniforms.shadow_pass.value=A.map.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(D,null,F,f,v,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.
resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(D,null,F,d,v,null)}function T(A,D,F,w){let S=null,R=F.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(R!==void 0)S=R;else if(S=F.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&
D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let O=S.uuid,z=D.uuid,W=c[O];W===void 0&&(W={},c[O]=W);let X=W[z];X===void 0&&(X=S.clone(),W[z]=X,D.addEventListener("dispose",C)),S=X}if(S.visible=D.visible,S.wireframe=D.wireframe,w===Xi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,
S.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,F.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let O=i.
properties.get(S);O.light=F}return S}function _(A,D,F,w,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Xi)&&(!A.frustumCulled||n.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(F.matrixWorldInverse,A.matrixWorld);let z=t.update(A),W=A.material;if(Array.isArray(W)){let X=z.groups;for(let q=0,Z=X.length;q<Z;q++){
let j=X[q],rt=W[j.materialIndex];if(rt&&rt.visible){let ot=T(A,rt,w,S);A.onBeforeShadow(i,A,D,F,z,ot,j),i.renderBufferDirect(F,null,z,ot,A,j),A.onAfterShadow(i,A,D,F,z,ot,j)}}}else if(W.visible){let X=T(A,W,w,S);A.onBeforeShadow(i,A,D,F,z,X,null),i.renderBufferDirect(F,null,z,X,A,null),A.onAfterShadow(i,A,D,F,z,X,null)}}let O=A.children;for(let z=0,W=O.length;z<W;z++)_(O[z],D,F,w,S)}function C(A){
A.target.removeEventListener("dispose",C);for(let F in c){let w=c[F],S=A.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}var US={[Sc]:wc,[Ec]:Cc,[Tc]:Rc,[sr]:Ac,[wc]:Sc,[Cc]:Ec,[Rc]:Tc,[Ac]:sr};function FS(i,t){function e(){let B=!1,ut=new tn,dt=null,Dt=new tn(0,0,0,0);return{setMask:function(ct){dt!==ct&&!B&&(i.colorMask(ct,ct,ct,ct),dt=ct)},setLocked:function(ct){B=ct},setClear:function(ct,st,Vt,re,Ue){
Ue===!0&&(ct*=re,st*=re,Vt*=re),ut.set(ct,st,Vt,re),Dt.equals(ut)===!1&&(i.clearColor(ct,st,Vt,re),Dt.copy(ut))},reset:function(){B=!1,dt=null,Dt.set(-1,0,0,0)}}}function n(){let B=!1,ut=!1,dt=null,Dt=null,ct=null;return{setReversed:function(st){if(ut!==st){let Vt=t.get("EXT_clip_control");st?Vt.clipControlEXT(Vt.LOWER_LEFT_EXT,Vt.ZERO_TO_ONE_EXT):Vt.clipControlEXT(Vt.LOWER_LEFT_EXT,Vt.NEGATIVE_ONE_TO_ONE_EXT),
ut=st;let re=ct;ct=null,this.setClear(re)}},getReversed:function(){return ut},setTest:function(st){st?tt(i.DEPTH_TEST):wt(i.DEPTH_TEST)},setMask:function(st){dt!==st&&!B&&(i.depthMask(st),dt=st)},setFunc:function(st){if(ut&&(st=US[st]),Dt!==st){switch(st){case Sc:i.depthFunc(i.NEVER);break;case wc:i.depthFunc(i.ALWAYS);break;case Ec:i.depthFunc(i.LESS);break;case sr:i.depthFunc(i.LEQUAL);break;case Tc:
i.depthFunc(i.EQUAL);break;case Ac:i.depthFunc(i.GEQUAL);break;case Cc:i.depthFunc(i.GREATER);break;case Rc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Dt=st}},setLocked:function(st){B=st},setClear:function(st){ct!==st&&(ut&&(st=1-st),i.clearDepth(st),ct=st)},reset:function(){B=!1,dt=null,Dt=null,ct=null,ut=!1}}}function s(){let B=!1,ut=null,dt=null,Dt=null,ct=null,st=null,Vt=null,
re=null,Ue=null;return{setTest:function(be){B||(be?tt(i.STENCIL_TEST):wt(i.STENCIL_TEST))},setMask:function(be){ut!==be&&!B&&(i.stencilMask(be),ut=be)},setFunc:function(be,Mn,Ne){(dt!==be||Dt!==Mn||ct!==Ne)&&(i.stencilFunc(be,Mn,Ne),dt=be,Dt=Mn,ct=Ne)},setOp:function(be,Mn,Ne){(st!==be||Vt!==Mn||re!==Ne)&&(i.stencilOp(be,Mn,Ne),st=be,Vt=Mn,re=Ne)},setLocked:function(be){B=be},setClear:function(be){
Ue!==be&&(i.clearStencil(be),Ue=be)},reset:function(){B=!1,ut=null,dt=null,Dt=null,ct=null,st=null,Vt=null,re=null,Ue=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,b=null,T=null,_=null,C=null,A=null,D=new ce(0,0,0),F=0,w=!1,S=null,R=null,O=null,z=null,W=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,Z=0,j=i.getParameter(
i.VERSION);j.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(j)[1]),q=Z>=1):j.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),q=Z>=2);let rt=null,ot={},vt=i.getParameter(i.SCISSOR_BOX),bt=i.getParameter(i.VIEWPORT),pt=new tn().fromArray(vt),se=new tn().fromArray(bt);function Kt(B,ut,dt,Dt){let ct=new Uint8Array(4),st=i.createTexture();i.bindTexture(B,st),i.texParameteri(
B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Vt=0;Vt<dt;Vt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ut,0,i.RGBA,1,1,Dt,0,i.RGBA,i.UNSIGNED_BYTE,ct):i.texImage2D(ut+Vt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ct);return st}let Q={};Q[i.TEXTURE_2D]=Kt(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=Kt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,
6),Q[i.TEXTURE_2D_ARRAY]=Kt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=Kt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),tt(i.DEPTH_TEST),o.setFunc(sr),Yt(!1),Ot(of),tt(i.CULL_FACE),xe(us);function tt(B){u[B]!==!0&&(i.enable(B),u[B]=!0)}function wt(B){u[B]!==!1&&(i.disable(B),u[B]=!1)}function zt(B,ut){return h[B]!==ut?(i.bindFramebuffer(B,ut),h[B]=ut,
B===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ut),B===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ut),!0):!1}function xt(B,ut){let dt=d,Dt=!1;if(B){dt=f.get(ut),dt===void 0&&(dt=[],f.set(ut,dt));let ct=B.textures;if(dt.length!==ct.length||dt[0]!==i.COLOR_ATTACHMENT0){for(let st=0,Vt=ct.length;st<Vt;st++)dt[st]=i.COLOR_ATTACHMENT0+st;dt.length=ct.length,Dt=!0}}else dt[0]!==i.BACK&&(dt[0]=i.BACK,Dt=!0);Dt&&i.
drawBuffers(dt)}function ne(B){return g!==B?(i.useProgram(B),g=B,!0):!1}let Pe={[Ns]:i.FUNC_ADD,[lm]:i.FUNC_SUBTRACT,[cm]:i.FUNC_REVERSE_SUBTRACT};Pe[hm]=i.MIN,Pe[um]=i.MAX;let U={[fm]:i.ZERO,[dm]:i.ONE,[pm]:i.SRC_COLOR,[Jl]:i.SRC_ALPHA,[_m]:i.SRC_ALPHA_SATURATE,[ym]:i.DST_COLOR,[gm]:i.DST_ALPHA,[mm]:i.ONE_MINUS_SRC_COLOR,[Kl]:i.ONE_MINUS_SRC_ALPHA,[xm]:i.ONE_MINUS_DST_COLOR,[vm]:i.ONE_MINUS_DST_ALPHA,
[bm]:i.CONSTANT_COLOR,[Mm]:i.ONE_MINUS_CONSTANT_COLOR,[Sm]:i.CONSTANT_ALPHA,[wm]:i.ONE_MINUS_CONSTANT_ALPHA};function xe(B,ut,dt,Dt,ct,st,Vt,re,Ue,be){if(B===us){v===!0&&(wt(i.BLEND),v=!1);return}if(v===!1&&(tt(i.BLEND),v=!0),B!==am){if(B!==m||be!==w){if((p!==Ns||_!==Ns)&&(i.blendEquation(i.FUNC_ADD),p=Ns,_=Ns),be)switch(B){case ir:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);
break;case lf:i.blendFunc(i.ONE,i.ONE);break;case cf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}else switch(B){case ir:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lf:i.blendFuncSeparate(
i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case cf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}b=null,T=null,C=null,A=null,D.set(0,0,0),F=0,m=B,w=be}return}ct=ct||ut,
st=st||dt,Vt=Vt||Dt,(ut!==p||ct!==_)&&(i.blendEquationSeparate(Pe[ut],Pe[ct]),p=ut,_=ct),(dt!==b||Dt!==T||st!==C||Vt!==A)&&(i.blendFuncSeparate(U[dt],U[Dt],U[st],U[Vt]),b=dt,T=Dt,C=st,A=Vt),(re.equals(D)===!1||Ue!==F)&&(i.blendColor(re.r,re.g,re.b,Ue),D.copy(re),F=Ue),m=B,w=!1}function te(B,ut){B.side===di?wt(i.CULL_FACE):tt(i.CULL_FACE);let dt=B.side===zn;ut&&(dt=!dt),Yt(dt),B.blending===ir&&B.transparent===
!1?xe(us):xe(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Dt=B.stencilWrite;a.setTest(Dt),Dt&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,
B.stencilZFail,B.stencilZPass)),Lt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?tt(i.SAMPLE_ALPHA_TO_COVERAGE):wt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Yt(B){S!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),S=B)}function Ot(B){B!==rm?(tt(i.CULL_FACE),B!==R&&(B===of?i.cullFace(i.BACK):B===om?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):wt(i.CULL_FACE),R=B}function Ie(B){
B!==O&&(q&&i.lineWidth(B),O=B)}function Lt(B,ut,dt){B?(tt(i.POLYGON_OFFSET_FILL),(z!==ut||W!==dt)&&(i.polygonOffset(ut,dt),z=ut,W=dt)):wt(i.POLYGON_OFFSET_FILL)}function qt(B){B?tt(i.SCISSOR_TEST):wt(i.SCISSOR_TEST)}function Ge(B){B===void 0&&(B=i.TEXTURE0+X-1),rt!==B&&(i.activeTexture(B),rt=B)}function Ee(B,ut,dt){dt===void 0&&(rt===null?dt=i.TEXTURE0+X-1:dt=rt);let Dt=ot[dt];Dt===void 0&&(Dt={type:void 0,
texture:void 0},ot[dt]=Dt),(Dt.type!==B||Dt.texture!==ut)&&(rt!==dt&&(i.activeTexture(dt),rt=dt),i.bindTexture(B,ut||Q[B]),Dt.type=B,Dt.texture=ut)}function I(){let B=ot[rt];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function N(){try{i.compressedTexImage3D(
...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function J(){try{i.texSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function nt(){try{i.texSubImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function et(){try{i.compressedTexSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Bt(){try{i.compressedTexSubImage3D(...arguments)}catch(B){
console.error("THREE.WebGLState:",B)}}function ht(){try{i.texStorage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Ut(){try{i.texStorage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Rt(){try{i.texImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function at(){try{i.texImage3D(...arguments)}catch(B){console.error("THREE.WebGLSt\
ate:",B)}}function gt(B){pt.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),pt.copy(B))}function Gt(B){se.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),se.copy(B))}function Ht(B,ut){let dt=c.get(ut);dt===void 0&&(dt=new WeakMap,c.set(ut,dt));let Dt=dt.get(B);Dt===void 0&&(Dt=i.getUniformBlockIndex(ut,B.name),dt.set(B,Dt))}function Mt(B,ut){let Dt=c.get(ut).get(B);l.get(ut)!==Dt&&(i.uniformBlockBinding(
ut,Dt,B.__bindingPointIndex),l.set(ut,Dt))}function ie(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(
0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),
i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},rt=null,ot={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,b=null,T=null,_=null,C=null,A=null,D=new ce(0,0,0),F=0,w=!1,S=null,R=null,O=null,z=null,W=null,pt.set(0,0,i.canvas.width,i.canvas.height),se.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}
return{buffers:{color:r,depth:o,stencil:a},enable:tt,disable:wt,bindFramebuffer:zt,drawBuffers:xt,useProgram:ne,setBlending:xe,setMaterial:te,setFlipSided:Yt,setCullFace:Ot,setLineWidth:Ie,setPolygonOffset:Lt,setScissorTest:qt,activeTexture:Ge,bindTexture:Ee,unbindTexture:I,compressedTexImage2D:x,compressedTexImage3D:N,texImage2D:Rt,texImage3D:at,updateUBOMapping:Ht,uniformBlockBinding:Mt,texStorage2D:ht,
texStorage3D:Ut,texSubImage2D:J,texSubImage3D:nt,compressedTexSubImage2D:et,compressedTexSubImage3D:Bt,scissor:gt,viewport:Gt,reset:ie}}function NS(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ge,u=new WeakMap,h,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<
"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,x){return d?new OffscreenCanvas(I,x):la("canvas")}function v(I,x,N){let J=1,nt=Ee(I);if((nt.width>N||nt.height>N)&&(J=N/Math.max(nt.width,nt.height)),J<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||
typeof VideoFrame<"u"&&I instanceof VideoFrame){let et=Math.floor(J*nt.width),Bt=Math.floor(J*nt.height);h===void 0&&(h=g(et,Bt));let ht=x?g(et,Bt):h;return ht.width=et,ht.height=Bt,ht.getContext("2d").drawImage(I,0,0,et,Bt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+et+"x"+Bt+")."),ht}else return"data"in I&&console.warn("THREE.WebGLRenderer\
: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),I;return I}function m(I){return I.generateMipmaps}function p(I){i.generateMipmap(I)}function b(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(I,x,N,J,nt=!1){if(I!==null){if(i[I]!==void 0)return i[I];
console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let et=x;if(x===i.RED&&(N===i.FLOAT&&(et=i.R32F),N===i.HALF_FLOAT&&(et=i.R16F),N===i.UNSIGNED_BYTE&&(et=i.R8)),x===i.RED_INTEGER&&(N===i.UNSIGNED_BYTE&&(et=i.R8UI),N===i.UNSIGNED_SHORT&&(et=i.R16UI),N===i.UNSIGNED_INT&&(et=i.R32UI),N===i.BYTE&&(et=i.R8I),N===i.SHORT&&(et=i.R16I),N===i.INT&&(et=i.R32I)),x===
i.RG&&(N===i.FLOAT&&(et=i.RG32F),N===i.HALF_FLOAT&&(et=i.RG16F),N===i.UNSIGNED_BYTE&&(et=i.RG8)),x===i.RG_INTEGER&&(N===i.UNSIGNED_BYTE&&(et=i.RG8UI),N===i.UNSIGNED_SHORT&&(et=i.RG16UI),N===i.UNSIGNED_INT&&(et=i.RG32UI),N===i.BYTE&&(et=i.RG8I),N===i.SHORT&&(et=i.RG16I),N===i.INT&&(et=i.RG32I)),x===i.RGB_INTEGER&&(N===i.UNSIGNED_BYTE&&(et=i.RGB8UI),N===i.UNSIGNED_SHORT&&(et=i.RGB16UI),N===i.UNSIGNED_INT&&
(et=i.RGB32UI),N===i.BYTE&&(et=i.RGB8I),N===i.SHORT&&(et=i.RGB16I),N===i.INT&&(et=i.RGB32I)),x===i.RGBA_INTEGER&&(N===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),N===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),N===i.UNSIGNED_INT&&(et=i.RGBA32UI),N===i.BYTE&&(et=i.RGBA8I),N===i.SHORT&&(et=i.RGBA16I),N===i.INT&&(et=i.RGBA32I)),x===i.RGB&&(N===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),N===i.UNSIGNED_INT_10F_11F_11F_REV&&
(et=i.R11F_G11F_B10F)),x===i.RGBA){let Bt=nt?oa:_e.getTransfer(J);N===i.FLOAT&&(et=i.RGBA32F),N===i.HALF_FLOAT&&(et=i.RGBA16F),N===i.UNSIGNED_BYTE&&(et=Bt===De?i.SRGB8_ALPHA8:i.RGBA8),N===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),N===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}
function _(I,x){let N;return I?x===null||x===zs||x===bo?N=i.DEPTH24_STENCIL8:x===Ri?N=i.DEPTH32F_STENCIL8:x===xo&&(N=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===zs||x===bo?N=i.DEPTH_COMPONENT24:x===Ri?N=i.DEPTH_COMPONENT32F:x===xo&&(N=i.DEPTH_COMPONENT16),N}function C(I,x){return m(I)===!0||I.isFramebufferTexture&&
I.minFilter!==Xn&&I.minFilter!==Ti?Math.log2(Math.max(x.width,x.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?x.mipmaps.length:1}function A(I){let x=I.target;x.removeEventListener("dispose",A),F(x),x.isVideoTexture&&u.delete(x)}function D(I){let x=I.target;x.removeEventListener("dispose",D),S(x)}function F(I){let x=n.get(I);if(x.__webglInit===
void 0)return;let N=I.source,J=f.get(N);if(J){let nt=J[x.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&w(I),Object.keys(J).length===0&&f.delete(N)}n.remove(I)}function w(I){let x=n.get(I);i.deleteTexture(x.__webglTexture);let N=I.source,J=f.get(N);delete J[x.__cacheKey],o.memory.textures--}function S(I){let x=n.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),n.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)
for(let J=0;J<6;J++){if(Array.isArray(x.__webglFramebuffer[J]))for(let nt=0;nt<x.__webglFramebuffer[J].length;nt++)i.deleteFramebuffer(x.__webglFramebuffer[J][nt]);else i.deleteFramebuffer(x.__webglFramebuffer[J]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[J])}else{if(Array.isArray(x.__webglFramebuffer))for(let J=0;J<x.__webglFramebuffer.length;J++)i.deleteFramebuffer(x.__webglFramebuffer[J]);else
i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let J=0;J<x.__webglColorRenderbuffer.length;J++)x.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[J]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(
x.__webglDepthRenderbuffer)}let N=I.textures;for(let J=0,nt=N.length;J<nt;J++){let et=n.get(N[J]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(N[J])}n.remove(I)}let R=0;function O(){R=0}function z(){let I=R;return I>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),R+=1,I}function W(I){
let x=[];return x.push(I.wrapS),x.push(I.wrapT),x.push(I.wrapR||0),x.push(I.magFilter),x.push(I.minFilter),x.push(I.anisotropy),x.push(I.internalFormat),x.push(I.format),x.push(I.type),x.push(I.generateMipmaps),x.push(I.premultiplyAlpha),x.push(I.flipY),x.push(I.unpackAlignment),x.push(I.colorSpace),x.join()}function X(I,x){let N=n.get(I);if(I.isVideoTexture&&qt(I),I.isRenderTargetTexture===!1&&I.
isExternalTexture!==!0&&I.version>0&&N.__version!==I.version){let J=I.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(N,I,x);return}}else I.isExternalTexture&&(N.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(
i.TEXTURE_2D,N.__webglTexture,i.TEXTURE0+x)}function q(I,x){let N=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&N.__version!==I.version){Q(N,I,x);return}e.bindTexture(i.TEXTURE_2D_ARRAY,N.__webglTexture,i.TEXTURE0+x)}function Z(I,x){let N=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&N.__version!==I.version){Q(N,I,x);return}e.bindTexture(i.TEXTURE_3D,N.__webglTexture,i.TEXTURE0+x)}
function j(I,x){let N=n.get(I);if(I.version>0&&N.__version!==I.version){tt(N,I,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+x)}let rt={[jl]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[Ql]:i.MIRRORED_REPEAT},ot={[Xn]:i.NEAREST,[Um]:i.NEAREST_MIPMAP_NEAREST,[Ra]:i.NEAREST_MIPMAP_LINEAR,[Ti]:i.LINEAR,[Lc]:i.LINEAR_MIPMAP_NEAREST,[ks]:i.LINEAR_MIPMAP_LINEAR},vt={[Bm]:i.NEVER,[Wm]:i.ALWAYS,
[km]:i.LESS,[xf]:i.LEQUAL,[zm]:i.EQUAL,[Gm]:i.GEQUAL,[Vm]:i.GREATER,[Hm]:i.NOTEQUAL};function bt(I,x){if(x.type===Ri&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===Ti||x.magFilter===Lc||x.magFilter===Ra||x.magFilter===ks||x.minFilter===Ti||x.minFilter===Lc||x.minFilter===Ra||x.minFilter===ks)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. \
OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,rt[x.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,rt[x.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,rt[x.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,ot[x.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,ot[x.minFilter]),x.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,
i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,vt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Xn||x.minFilter!==Ra&&x.minFilter!==ks||x.type===Ri&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let N=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,N.TEXTURE_MAX_ANISOTROPY_EXT,Math.
min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function pt(I,x){let N=!1;I.__webglInit===void 0&&(I.__webglInit=!0,x.addEventListener("dispose",A));let J=x.source,nt=f.get(J);nt===void 0&&(nt={},f.set(J,nt));let et=W(x);if(et!==I.__cacheKey){nt[et]===void 0&&(nt[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,N=!0),nt[et].usedTimes++;let Bt=nt[I.
__cacheKey];Bt!==void 0&&(nt[I.__cacheKey].usedTimes--,Bt.usedTimes===0&&w(x)),I.__cacheKey=et,I.__webglTexture=nt[et].texture}return N}function se(I,x,N){return Math.floor(Math.floor(I/N)/x)}function Kt(I,x,N,J){let et=I.updateRanges;if(et.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,N,J,x.data);else{et.sort((at,gt)=>at.start-gt.start);let Bt=0;for(let at=1;at<et.length;at++){let gt=et[Bt],
Gt=et[at],Ht=gt.start+gt.count,Mt=se(Gt.start,x.width,4),ie=se(gt.start,x.width,4);Gt.start<=Ht+1&&Mt===ie&&se(Gt.start+Gt.count-1,x.width,4)===Mt?gt.count=Math.max(gt.count,Gt.start+Gt.count-gt.start):(++Bt,et[Bt]=Gt)}et.length=Bt+1;let ht=i.getParameter(i.UNPACK_ROW_LENGTH),Ut=i.getParameter(i.UNPACK_SKIP_PIXELS),Rt=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let at=0,
gt=et.length;at<gt;at++){let Gt=et[at],Ht=Math.floor(Gt.start/4),Mt=Math.ceil(Gt.count/4),ie=Ht%x.width,B=Math.floor(Ht/x.width),ut=Mt,dt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),i.pixelStorei(i.UNPACK_SKIP_ROWS,B),e.texSubImage2D(i.TEXTURE_2D,0,ie,B,ut,dt,N,J,x.data)}I.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ht),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ut),i.pixelStorei(i.UNPACK_SKIP_ROWS,
Rt)}}function Q(I,x,N){let J=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(J=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(J=i.TEXTURE_3D);let nt=pt(I,x),et=x.source;e.bindTexture(J,I.__webglTexture,i.TEXTURE0+N);let Bt=n.get(et);if(et.version!==Bt.__version||nt===!0){e.activeTexture(i.TEXTURE0+N);let ht=_e.getPrimaries(_e.workingColorSpace),Ut=x.colorSpace===ds?null:_e.getPrimaries(
x.colorSpace),Rt=x.colorSpace===ds||ht===Ut?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Rt);let at=v(x.image,!1,s.maxTextureSize);at=Ge(x,at);let gt=r.convert(x.format,x.colorSpace),Gt=r.convert(x.type),
Ht=T(x.internalFormat,gt,Gt,x.colorSpace,x.isVideoTexture);bt(J,x);let Mt,ie=x.mipmaps,B=x.isVideoTexture!==!0,ut=Bt.__version===void 0||nt===!0,dt=et.dataReady,Dt=C(x,at);if(x.isDepthTexture)Ht=_(x.format===Mo,x.type),ut&&(B?e.texStorage2D(i.TEXTURE_2D,1,Ht,at.width,at.height):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,gt,Gt,null));else if(x.isDataTexture)if(ie.length>0){B&&ut&&e.texStorage2D(
i.TEXTURE_2D,Dt,Ht,ie[0].width,ie[0].height);for(let ct=0,st=ie.length;ct<st;ct++)Mt=ie[ct],B?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,Mt.width,Mt.height,gt,Gt,Mt.data):e.texImage2D(i.TEXTURE_2D,ct,Ht,Mt.width,Mt.height,0,gt,Gt,Mt.data);x.generateMipmaps=!1}else B?(ut&&e.texStorage2D(i.TEXTURE_2D,Dt,Ht,at.width,at.height),dt&&Kt(x,at,gt,Gt)):e.texImage2D(i.TEXTURE_2D,0,Ht,at.width,at.height,0,gt,Gt,
at.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){B&&ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Dt,Ht,ie[0].width,ie[0].height,at.depth);for(let ct=0,st=ie.length;ct<st;ct++)if(Mt=ie[ct],x.format!==pi)if(gt!==null)if(B){if(dt)if(x.layerUpdates.size>0){let Vt=Ef(Mt.width,Mt.height,x.format,x.type);for(let re of x.layerUpdates){let Ue=Mt.data.subarray(re*Vt/Mt.data.BYTES_PER_ELEMENT,(re+
1)*Vt/Mt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,re,Mt.width,Mt.height,1,gt,Ue)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,Mt.width,Mt.height,at.depth,gt,Mt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,Ht,Mt.width,Mt.height,at.depth,0,Mt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported\
 compressed texture format in .uploadTexture()");else B?dt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,Mt.width,Mt.height,at.depth,gt,Gt,Mt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,Ht,Mt.width,Mt.height,at.depth,0,gt,Gt,Mt.data)}else{B&&ut&&e.texStorage2D(i.TEXTURE_2D,Dt,Ht,ie[0].width,ie[0].height);for(let ct=0,st=ie.length;ct<st;ct++)Mt=ie[ct],x.format!==pi?gt!==null?B?dt&&e.compressedTexSubImage2D(
i.TEXTURE_2D,ct,0,0,Mt.width,Mt.height,gt,Mt.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,Ht,Mt.width,Mt.height,0,Mt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):B?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,Mt.width,Mt.height,gt,Gt,Mt.data):e.texImage2D(i.TEXTURE_2D,ct,Ht,Mt.width,Mt.height,0,gt,Gt,Mt.data)}else if(x.isDataArrayTexture)
if(B){if(ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Dt,Ht,at.width,at.height,at.depth),dt)if(x.layerUpdates.size>0){let ct=Ef(at.width,at.height,x.format,x.type);for(let st of x.layerUpdates){let Vt=at.data.subarray(st*ct/at.data.BYTES_PER_ELEMENT,(st+1)*ct/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,st,at.width,at.height,1,gt,Gt,Vt)}x.clearLayerUpdates()}else e.texSubImage3D(i.
TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,gt,Gt,at.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ht,at.width,at.height,at.depth,0,gt,Gt,at.data);else if(x.isData3DTexture)B?(ut&&e.texStorage3D(i.TEXTURE_3D,Dt,Ht,at.width,at.height,at.depth),dt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,gt,Gt,at.data)):e.texImage3D(i.TEXTURE_3D,0,Ht,at.width,at.height,at.depth,0,gt,
Gt,at.data);else if(x.isFramebufferTexture){if(ut)if(B)e.texStorage2D(i.TEXTURE_2D,Dt,Ht,at.width,at.height);else{let ct=at.width,st=at.height;for(let Vt=0;Vt<Dt;Vt++)e.texImage2D(i.TEXTURE_2D,Vt,Ht,ct,st,0,gt,Gt,null),ct>>=1,st>>=1}}else if(ie.length>0){if(B&&ut){let ct=Ee(ie[0]);e.texStorage2D(i.TEXTURE_2D,Dt,Ht,ct.width,ct.height)}for(let ct=0,st=ie.length;ct<st;ct++)Mt=ie[ct],B?dt&&e.texSubImage2D(
i.TEXTURE_2D,ct,0,0,gt,Gt,Mt):e.texImage2D(i.TEXTURE_2D,ct,Ht,gt,Gt,Mt);x.generateMipmaps=!1}else if(B){if(ut){let ct=Ee(at);e.texStorage2D(i.TEXTURE_2D,Dt,Ht,ct.width,ct.height)}dt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,Gt,at)}else e.texImage2D(i.TEXTURE_2D,0,Ht,gt,Gt,at);m(x)&&p(J),Bt.__version=et.version,x.onUpdate&&x.onUpdate(x)}I.__version=x.version}function tt(I,x,N){if(x.image.length!==6)return;
let J=pt(I,x),nt=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+N);let et=n.get(nt);if(nt.version!==et.__version||J===!0){e.activeTexture(i.TEXTURE0+N);let Bt=_e.getPrimaries(_e.workingColorSpace),ht=x.colorSpace===ds?null:_e.getPrimaries(x.colorSpace),Ut=x.colorSpace===ds||Bt===ht?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ut);let Rt=x.isCompressedTexture||x.image[0].isCompressedTexture,at=x.image[0]&&x.image[0].isDataTexture,gt=[];for(let st=0;st<6;st++)!Rt&&!at?gt[st]=v(x.image[st],!0,s.maxCubemapSize):gt[st]=at?x.image[st].image:x.image[st],gt[st]=Ge(x,gt[st]);let Gt=gt[0],Ht=r.convert(x.format,
x.colorSpace),Mt=r.convert(x.type),ie=T(x.internalFormat,Ht,Mt,x.colorSpace),B=x.isVideoTexture!==!0,ut=et.__version===void 0||J===!0,dt=nt.dataReady,Dt=C(x,Gt);bt(i.TEXTURE_CUBE_MAP,x);let ct;if(Rt){B&&ut&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Dt,ie,Gt.width,Gt.height);for(let st=0;st<6;st++){ct=gt[st].mipmaps;for(let Vt=0;Vt<ct.length;Vt++){let re=ct[Vt];x.format!==pi?Ht!==null?B?dt&&e.compressedTexSubImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt,0,0,re.width,re.height,Ht,re.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt,ie,re.width,re.height,0,re.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt,0,0,re.width,re.height,Ht,Mt,re.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
st,Vt,ie,re.width,re.height,0,Ht,Mt,re.data)}}}else{if(ct=x.mipmaps,B&&ut){ct.length>0&&Dt++;let st=Ee(gt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Dt,ie,st.width,st.height)}for(let st=0;st<6;st++)if(at){B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,gt[st].width,gt[st].height,Ht,Mt,gt[st].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,ie,gt[st].width,gt[st].height,0,Ht,Mt,gt[st].
data);for(let Vt=0;Vt<ct.length;Vt++){let Ue=ct[Vt].image[st].image;B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt+1,0,0,Ue.width,Ue.height,Ht,Mt,Ue.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt+1,ie,Ue.width,Ue.height,0,Ht,Mt,Ue.data)}}else{B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,Ht,Mt,gt[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,ie,Ht,Mt,gt[st]);
for(let Vt=0;Vt<ct.length;Vt++){let re=ct[Vt];B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt+1,0,0,Ht,Mt,re.image[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Vt+1,ie,Ht,Mt,re.image[st])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),et.__version=nt.version,x.onUpdate&&x.onUpdate(x)}I.__version=x.version}function wt(I,x,N,J,nt,et){let Bt=r.convert(N.format,N.colorSpace),ht=r.convert(N.type),Ut=T(N.
internalFormat,Bt,ht,N.colorSpace),Rt=n.get(x),at=n.get(N);if(at.__renderTarget=x,!Rt.__hasExternalTextures){let gt=Math.max(1,x.width>>et),Gt=Math.max(1,x.height>>et);nt===i.TEXTURE_3D||nt===i.TEXTURE_2D_ARRAY?e.texImage3D(nt,et,Ut,gt,Gt,x.depth,0,Bt,ht,null):e.texImage2D(nt,et,Ut,gt,Gt,0,Bt,ht,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),Lt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,J,nt,
at.__webglTexture,0,Ie(x)):(nt===i.TEXTURE_2D||nt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,J,nt,at.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function zt(I,x,N){if(i.bindRenderbuffer(i.RENDERBUFFER,I),x.depthBuffer){let J=x.depthTexture,nt=J&&J.isDepthTexture?J.type:null,et=_(x.stencilBuffer,nt),Bt=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:
i.DEPTH_ATTACHMENT,ht=Ie(x);Lt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht,et,x.width,x.height):N?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht,et,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,et,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Bt,i.RENDERBUFFER,I)}else{let J=x.textures;for(let nt=0;nt<J.length;nt++){let et=J[nt],Bt=r.convert(et.format,et.colorSpace),
ht=r.convert(et.type),Ut=T(et.internalFormat,Bt,ht,et.colorSpace),Rt=Ie(x);N&&Lt(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Rt,Ut,x.width,x.height):Lt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Rt,Ut,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Ut,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(I,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error(
"Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let J=n.get(x.depthTexture);J.__renderTarget=x,(!J.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.
width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),X(x.depthTexture,0);let nt=J.__webglTexture,et=Ie(x);if(x.depthTexture.format===io)Lt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0);else if(x.depthTexture.format===Mo)Lt(x)?a.framebufferTexture2DMultisampleEXT(
i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0);else throw new Error("Unknown depthTexture format")}function ne(I){let x=n.get(I),N=I.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==I.depthTexture){let J=I.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),J){let nt=()=>{delete x.
__boundDepthTexture,delete x.__depthDisposeCallback,J.removeEventListener("dispose",nt)};J.addEventListener("dispose",nt),x.__depthDisposeCallback=nt}x.__boundDepthTexture=J}if(I.depthTexture&&!x.__autoAllocateDepthBuffer){if(N)throw new Error("target.depthTexture not supported in Cube render targets");let J=I.texture.mipmaps;J&&J.length>0?xt(x.__webglFramebuffer[0],I):xt(x.__webglFramebuffer,I)}else if(N){
x.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[J]),x.__webglDepthbuffer[J]===void 0)x.__webglDepthbuffer[J]=i.createRenderbuffer(),zt(x.__webglDepthbuffer[J],I,!1);else{let nt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=x.__webglDepthbuffer[J];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.
RENDERBUFFER,et)}}else{let J=I.texture.mipmaps;if(J&&J.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),zt(x.__webglDepthbuffer,I,!1);else{let nt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,
et),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,et)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Pe(I,x,N){let J=n.get(I);x!==void 0&&wt(J.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),N!==void 0&&ne(I)}function U(I){let x=I.texture,N=n.get(I),J=n.get(x);I.addEventListener("dispose",D);let nt=I.textures,et=I.isWebGLCubeRenderTarget===!0,Bt=nt.length>1;if(Bt||(J.
__webglTexture===void 0&&(J.__webglTexture=i.createTexture()),J.__version=x.version,o.memory.textures++),et){N.__webglFramebuffer=[];for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer[ht]=[];for(let Ut=0;Ut<x.mipmaps.length;Ut++)N.__webglFramebuffer[ht][Ut]=i.createFramebuffer()}else N.__webglFramebuffer[ht]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){N.
__webglFramebuffer=[];for(let ht=0;ht<x.mipmaps.length;ht++)N.__webglFramebuffer[ht]=i.createFramebuffer()}else N.__webglFramebuffer=i.createFramebuffer();if(Bt)for(let ht=0,Ut=nt.length;ht<Ut;ht++){let Rt=n.get(nt[ht]);Rt.__webglTexture===void 0&&(Rt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Lt(I)===!1){N.__webglMultisampledFramebuffer=i.createFramebuffer(),N.__webglColorRenderbuffer=
[],e.bindFramebuffer(i.FRAMEBUFFER,N.__webglMultisampledFramebuffer);for(let ht=0;ht<nt.length;ht++){let Ut=nt[ht];N.__webglColorRenderbuffer[ht]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,N.__webglColorRenderbuffer[ht]);let Rt=r.convert(Ut.format,Ut.colorSpace),at=r.convert(Ut.type),gt=T(Ut.internalFormat,Rt,at,Ut.colorSpace,I.isXRRenderTarget===!0),Gt=Ie(I);i.renderbufferStorageMultisample(
i.RENDERBUFFER,Gt,gt,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ht,i.RENDERBUFFER,N.__webglColorRenderbuffer[ht])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(N.__webglDepthRenderbuffer=i.createRenderbuffer(),zt(N.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture),bt(i.TEXTURE_CUBE_MAP,
x);for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0)for(let Ut=0;Ut<x.mipmaps.length;Ut++)wt(N.__webglFramebuffer[ht][Ut],I,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,Ut);else wt(N.__webglFramebuffer[ht],I,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,0);m(x)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Bt){for(let ht=0,Ut=nt.length;ht<Ut;ht++){let Rt=nt[ht],at=n.get(
Rt),gt=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(gt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(gt,at.__webglTexture),bt(gt,Rt),wt(N.__webglFramebuffer,I,Rt,i.COLOR_ATTACHMENT0+ht,gt,0),m(Rt)&&p(gt)}e.unbindTexture()}else{let ht=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ht=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),
e.bindTexture(ht,J.__webglTexture),bt(ht,x),x.mipmaps&&x.mipmaps.length>0)for(let Ut=0;Ut<x.mipmaps.length;Ut++)wt(N.__webglFramebuffer[Ut],I,x,i.COLOR_ATTACHMENT0,ht,Ut);else wt(N.__webglFramebuffer,I,x,i.COLOR_ATTACHMENT0,ht,0);m(x)&&p(ht),e.unbindTexture()}I.depthBuffer&&ne(I)}function xe(I){let x=I.textures;for(let N=0,J=x.length;N<J;N++){let nt=x[N];if(m(nt)){let et=b(I),Bt=n.get(nt).__webglTexture;
e.bindTexture(et,Bt),p(et),e.unbindTexture()}}}let te=[],Yt=[];function Ot(I){if(I.samples>0){if(Lt(I)===!1){let x=I.textures,N=I.width,J=I.height,nt=i.COLOR_BUFFER_BIT,et=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Bt=n.get(I),ht=x.length>1;if(ht)for(let Rt=0;Rt<x.length;Rt++)e.bindFramebuffer(i.FRAMEBUFFER,Bt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,
i.COLOR_ATTACHMENT0+Rt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Bt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Rt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Bt.__webglMultisampledFramebuffer);let Ut=I.texture.mipmaps;Ut&&Ut.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Bt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Bt.
__webglFramebuffer);for(let Rt=0;Rt<x.length;Rt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(nt|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(nt|=i.STENCIL_BUFFER_BIT)),ht){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Bt.__webglColorRenderbuffer[Rt]);let at=n.get(x[Rt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,
i.TEXTURE_2D,at,0)}i.blitFramebuffer(0,0,N,J,0,0,N,J,nt,i.NEAREST),l===!0&&(te.length=0,Yt.length=0,te.push(i.COLOR_ATTACHMENT0+Rt),I.depthBuffer&&I.resolveDepthBuffer===!1&&(te.push(et),Yt.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Yt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,te))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ht)for(let Rt=0;Rt<
x.length;Rt++){e.bindFramebuffer(i.FRAMEBUFFER,Bt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Rt,i.RENDERBUFFER,Bt.__webglColorRenderbuffer[Rt]);let at=n.get(x[Rt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Bt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Rt,i.TEXTURE_2D,at,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,
Bt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&l){let x=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Ie(I){return Math.min(s.maxSamples,I.samples)}function Lt(I){let x=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function qt(I){
let x=o.render.frame;u.get(I)!==x&&(u.set(I,x),I.update())}function Ge(I,x){let N=I.colorSpace,J=I.format,nt=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||N!==rr&&N!==ds&&(_e.getTransfer(N)===De?(J!==pi||nt!==Ci)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color s\
pace:",N)),x}function Ee(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=O,this.setTexture2D=X,this.setTexture2DArray=q,this.
setTexture3D=Z,this.setTextureCube=j,this.rebindTextures=Pe,this.setupRenderTarget=U,this.updateRenderTargetMipmap=xe,this.updateMultisampleRenderTarget=Ot,this.setupDepthRenderbuffer=ne,this.setupFrameBufferTexture=wt,this.useMultisampledRTT=Lt}function OS(i,t){function e(n,s=ds){let r,o=_e.getTransfer(s);if(n===Ci)return i.UNSIGNED_BYTE;if(n===Uc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Fc)return i.
UNSIGNED_SHORT_5_5_5_1;if(n===pf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===mf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ff)return i.BYTE;if(n===df)return i.SHORT;if(n===xo)return i.UNSIGNED_SHORT;if(n===Dc)return i.INT;if(n===zs)return i.UNSIGNED_INT;if(n===Ri)return i.FLOAT;if(n===_o)return i.HALF_FLOAT;if(n===gf)return i.ALPHA;if(n===vf)return i.RGB;if(n===pi)return i.RGBA;if(n===io)return i.DEPTH_COMPONENT;
if(n===Mo)return i.DEPTH_STENCIL;if(n===Nc)return i.RED;if(n===Oc)return i.RED_INTEGER;if(n===yf)return i.RG;if(n===Bc)return i.RG_INTEGER;if(n===kc)return i.RGBA_INTEGER;if(n===Pa||n===Ia||n===La||n===Da)if(o===De)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Pa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;
if(n===Da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Pa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ia)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Da)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===zc||n===Vc||n===Hc||n===Gc)if(r=t.get("WEBGL_compr\
essed_texture_pvrtc"),r!==null){if(n===zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Vc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Gc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Wc||n===Xc||n===qc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Wc||n===Xc)return o===De?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;
if(n===qc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Yc||n===$c||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===rh||n===oh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Yc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===$c)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:
r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Zc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Jc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Kc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===jc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;
if(n===Qc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===th)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===eh)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===nh)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ih)return o===
De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===sh)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===rh)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===oh)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ah||n===
lh||n===ch)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===ah)return o===De?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===lh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ch)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===hh||n===uh||n===fh||n===dh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===hh)return r.COMPRESSED_RED_RGTC1_EXT;
if(n===uh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===fh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===dh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===bo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var BS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,kS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Bf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ya(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ai({vertexShader:BS,fragmentShader:kS,uniforms:{
depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new An(new ba(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kf=class extends ls{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null,v=typeof XRWebGLBinding<"u",m=new Bf,p={},b=e.getContextAttributes(),
T=null,_=null,C=[],A=[],D=new ge,F=null,w=new In;w.viewport=new tn;let S=new In;S.viewport=new tn;let R=[w,S],O=new bc,z=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let tt=C[Q];return tt===void 0&&(tt=new lo,C[Q]=tt),tt.getTargetRaySpace()},this.getControllerGrip=function(Q){let tt=C[Q];return tt===void 0&&(tt=new lo,C[Q]=tt),tt.getGripSpace()},
this.getHand=function(Q){let tt=C[Q];return tt===void 0&&(tt=new lo,C[Q]=tt),tt.getHandSpace()};function X(Q){let tt=A.indexOf(Q.inputSource);if(tt===-1)return;let wt=C[tt];wt!==void 0&&(wt.update(Q.inputSource,Q.frame,c||o),wt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function q(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),
s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",Z);for(let Q=0;Q<C.length;Q++){let tt=A[Q];tt!==null&&(A[Q]=null,C[Q].disconnect(tt))}z=null,W=null,m.reset();for(let Q in p)delete p[Q];t.setRenderTarget(T),d=null,f=null,h=null,s=null,_=null,Kt.stop(),n.isPresenting=
!1,t.setPixelRatio(F),t.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.
getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener(
"selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",q),s.addEventListener("inputsourceschange",Z),b.xrCompatible!==!0&&await e.makeXRCompatible(),F=t.getPixelRatio(),t.getSize(D),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let wt=null,zt=null,xt=null;b.depth&&(xt=
b.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,wt=b.stencil?Mo:io,zt=b.stencil?bo:zs);let ne={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(ne),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),_=new Hi(f.textureWidth,f.textureHeight,{format:pi,type:Ci,depthTexture:new va(f.textureWidth,f.textureHeight,
zt,void 0,void 0,void 0,void 0,void 0,void 0,wt),stencilBuffer:b.stencil,colorSpace:t.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let wt={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,wt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),
t.setSize(d.framebufferWidth,d.framebufferHeight,!1),_=new Hi(d.framebufferWidth,d.framebufferHeight,{format:pi,type:Ci,colorSpace:t.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Kt.setContext(s),Kt.start(),n.isPresenting=!0,n.dispatchEvent(
{type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Z(Q){for(let tt=0;tt<Q.removed.length;tt++){let wt=Q.removed[tt],zt=A.indexOf(wt);zt>=0&&(A[zt]=null,C[zt].disconnect(wt))}for(let tt=0;tt<Q.added.length;tt++){let wt=Q.added[tt],zt=A.indexOf(wt);if(zt===-1){for(let ne=0;ne<
C.length;ne++)if(ne>=A.length){A.push(wt),zt=ne;break}else if(A[ne]===null){A[ne]=wt,zt=ne;break}if(zt===-1)break}let xt=C[zt];xt&&xt.connect(wt)}}let j=new H,rt=new H;function ot(Q,tt,wt){j.setFromMatrixPosition(tt.matrixWorld),rt.setFromMatrixPosition(wt.matrixWorld);let zt=j.distanceTo(rt),xt=tt.projectionMatrix.elements,ne=wt.projectionMatrix.elements,Pe=xt[14]/(xt[10]-1),U=xt[14]/(xt[10]+1),xe=(xt[9]+
1)/xt[5],te=(xt[9]-1)/xt[5],Yt=(xt[8]-1)/xt[0],Ot=(ne[8]+1)/ne[0],Ie=Pe*Yt,Lt=Pe*Ot,qt=zt/(-Yt+Ot),Ge=qt*-Yt;if(tt.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Ge),Q.translateZ(qt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),xt[10]===-1)Q.projectionMatrix.copy(tt.projectionMatrix),Q.projectionMatrixInverse.copy(tt.
projectionMatrixInverse);else{let Ee=Pe+qt,I=U+qt,x=Ie-Ge,N=Lt+(zt-Ge),J=xe*U/I*Ee,nt=te*U/I*Ee;Q.projectionMatrix.makePerspective(x,N,J,nt,Ee,I),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function vt(Q,tt){tt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(tt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){
if(s===null)return;let tt=Q.near,wt=Q.far;m.texture!==null&&(m.depthNear>0&&(tt=m.depthNear),m.depthFar>0&&(wt=m.depthFar)),O.near=S.near=w.near=tt,O.far=S.far=w.far=wt,(z!==O.near||W!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),z=O.near,W=O.far),O.layers.mask=Q.layers.mask|6,w.layers.mask=O.layers.mask&3,S.layers.mask=O.layers.mask&5;let zt=Q.parent,xt=O.cameras;vt(O,zt);for(let ne=0;ne<
xt.length;ne++)vt(xt[ne],zt);xt.length===2?ot(O,w,S):O.projectionMatrix.copy(w.projectionMatrix),bt(Q,O,zt)};function bt(Q,tt,wt){wt===null?Q.matrix.copy(tt.matrixWorld):(Q.matrix.copy(wt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(tt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(tt.projectionMatrix),Q.projectionMatrixInverse.
copy(tt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=ec*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},
this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(Q){return p[Q]};let pt=null;function se(Q,tt){if(u=tt.getViewerPose(c||o),g=tt,u!==null){let wt=u.views;d!==null&&(t.setRenderTargetFramebuffer(_,d.framebuffer),t.setRenderTarget(_));let zt=!1;wt.length!==O.cameras.length&&(O.cameras.length=0,zt=!0);for(let U=0;U<wt.length;U++){let xe=wt[U],te=null;if(d!==null)
te=d.getViewport(xe);else{let Ot=h.getViewSubImage(f,xe);te=Ot.viewport,U===0&&(t.setRenderTargetTextures(_,Ot.colorTexture,Ot.depthStencilTexture),t.setRenderTarget(_))}let Yt=R[U];Yt===void 0&&(Yt=new In,Yt.layers.enable(U),Yt.viewport=new tn,R[U]=Yt),Yt.matrix.fromArray(xe.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(xe.projectionMatrix),
Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(te.x,te.y,te.width,te.height),U===0&&(O.matrix.copy(Yt.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),zt===!0&&O.cameras.push(Yt)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let U=h.getDepthInformation(wt[0]);U&&U.isValid&&U.texture&&m.init(
U,s.renderState)}if(xt&&xt.includes("camera-access")&&v){t.state.unbindTexture(),h=n.getBinding();for(let U=0;U<wt.length;U++){let xe=wt[U].camera;if(xe){let te=p[xe];te||(te=new ya,p[xe]=te);let Yt=h.getCameraImage(xe);te.sourceTexture=Yt}}}}for(let wt=0;wt<C.length;wt++){let zt=A[wt],xt=C[wt];zt!==null&&xt!==void 0&&xt.update(zt,tt,c||o)}pt&&pt(Q,tt),tt.detectedPlanes&&n.dispatchEvent({type:"pla\
nesdetected",data:tt}),g=null}let Kt=new xg;Kt.setAnimationLoop(se),this.setAnimationLoop=function(Q){pt=Q},this.dispose=function(){}}},gr=new fi,zS=new de;function VS(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Mf(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}
function s(m,p,b,T,_){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,_)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&
a(m,p)):p.isPointsMaterial?l(m,p,b,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.
alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===zn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===zn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.
value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let b=t.
get(p),T=b.envMap,_=b.envMapRotation;T&&(m.envMap.value=T,gr.copy(_),gr.x*=-1,gr.y*=-1,gr.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(gr.y*=-1,gr.z*=-1),m.envMapRotation.value.setFromMatrix4(zS.makeRotationFromEuler(gr)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.
lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.
value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,b,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*b,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=
p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.
value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,b){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),
m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,
e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===zn&&m.clearcoatNormalScale.
value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.
iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),
m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=
p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}
function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let b=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function HS(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,T){let _=T.
program;n.uniformBlockBinding(b,_)}function c(b,T){let _=s[b.id];_===void 0&&(g(b),_=u(b),s[b.id]=_,b.addEventListener("dispose",m));let C=T.program;n.updateUBOMapping(b,C);let A=t.render.frame;r[b.id]!==A&&(f(b),r[b.id]=A)}function u(b){let T=h();b.__bindingPointIndex=T;let _=i.createBuffer(),C=b.__size,A=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,C,A),i.bindBuffer(
i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,_),_}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let T=s[b.id],_=b.uniforms,C=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let A=0,D=_.length;A<D;A++){let F=Array.isArray(_[A])?_[A]:[_[A]];
for(let w=0,S=F.length;w<S;w++){let R=F[w];if(d(R,A,w,C)===!0){let O=R.__offset,z=Array.isArray(R.value)?R.value:[R.value],W=0;for(let X=0;X<z.length;X++){let q=z[X],Z=v(q);typeof q=="number"||typeof q=="boolean"?(R.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,O+W,R.__data)):q.isMatrix3?(R.__data[0]=q.elements[0],R.__data[1]=q.elements[1],R.__data[2]=q.elements[2],R.__data[3]=0,R.__data[4]=q.elements[3],
R.__data[5]=q.elements[4],R.__data[6]=q.elements[5],R.__data[7]=0,R.__data[8]=q.elements[6],R.__data[9]=q.elements[7],R.__data[10]=q.elements[8],R.__data[11]=0):(q.toArray(R.__data,W),W+=Z.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,O,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(b,T,_,C){let A=b.value,D=T+"_"+_;if(C[D]===void 0)return typeof A=="number"||
typeof A=="boolean"?C[D]=A:C[D]=A.clone(),!0;{let F=C[D];if(typeof A=="number"||typeof A=="boolean"){if(F!==A)return C[D]=A,!0}else if(F.equals(A)===!1)return F.copy(A),!0}return!1}function g(b){let T=b.uniforms,_=0,C=16;for(let D=0,F=T.length;D<F;D++){let w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,R=w.length;S<R;S++){let O=w[S],z=Array.isArray(O.value)?O.value:[O.value];for(let W=0,X=z.length;W<
X;W++){let q=z[W],Z=v(q),j=_%C,rt=j%Z.boundary,ot=j+rt;_+=rt,ot!==0&&C-ot<Z.storage&&(_+=C-ot),O.__data=new Float32Array(Z.storage/Float32Array.BYTES_PER_ELEMENT),O.__offset=_,_+=Z.storage}}}let A=_%C;return A>0&&(_+=C-A),b.__size=_,b.__cache={},this}function v(b){let T={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(T.boundary=4,T.storage=4):b.isVector2?(T.boundary=8,T.storage=
8):b.isVector3||b.isColor?(T.boundary=16,T.storage=12):b.isVector4?(T.boundary=16,T.storage=16):b.isMatrix3?(T.boundary=48,T.storage=48):b.isMatrix4?(T.boundary=64,T.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),T}function m(b){let T=b.target;T.removeEventListener(
"dispose",m);let _=o.indexOf(T.__bindingPointIndex);o.splice(_,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var xh=class{constructor(t={}){let{canvas:e=Xm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="\
default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;let g=new Uint32Array(4),v=new Int32Array(4),m=null,p=null,b=[],T=[];this.domElement=e,this.debug=
{checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let _=this,C=!1;this._outputColorSpace=ti;let A=0,D=0,F=null,w=-1,S=null,R=new tn,O=new tn,z=null,W=new ce(0),X=0,q=e.
width,Z=e.height,j=1,rt=null,ot=null,vt=new tn(0,0,q,Z),bt=new tn(0,0,q,Z),pt=!1,se=new ho,Kt=!1,Q=!1,tt=new de,wt=new H,zt=new tn,xt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ne=!1;function Pe(){return F===null?j:1}let U=n;function xe(E,V){return e.getContext(E,V)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,
failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",dt,!1),e.addEventListener("webglcontextrestored",Dt,!1),e.addEventListener("webglcontextcreationerror",ct,!1),U===null){let V="webgl2";if(U=xe(V,E),U===null)throw xe(V)?new Error("Error creating WebGL context with your selected attributes."):new Error("Err\
or creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let te,Yt,Ot,Ie,Lt,qt,Ge,Ee,I,x,N,J,nt,et,Bt,ht,Ut,Rt,at,gt,Gt,Ht,Mt,ie;function B(){te=new oM(U),te.init(),Ht=new OS(U,te),Yt=new Qb(U,te,t,Ht),Ot=new FS(U,te),Yt.reversedDepthBuffer&&f&&Ot.buffers.depth.setReversed(!0),Ie=new cM(U),Lt=new MS,qt=new NS(U,te,Ot,Lt,Yt,Ht,Ie),Ge=new eM(_),Ee=new rM(_),I=new mx(
U),Mt=new Kb(U,I),x=new aM(U,I,Ie,Mt),N=new uM(U,x,I,Ie),at=new hM(U,Yt,qt),ht=new tM(Lt),J=new bS(_,Ge,Ee,te,Yt,Mt,ht),nt=new VS(_,Lt),et=new wS,Bt=new PS(te),Rt=new Jb(_,Ge,Ee,Ot,N,d,l),Ut=new DS(_,N,Yt),ie=new HS(U,Ie,Yt,Ot),gt=new jb(U,te,Ie),Gt=new lM(U,te,Ie),Ie.programs=J.programs,_.capabilities=Yt,_.extensions=te,_.properties=Lt,_.renderLists=et,_.shadowMap=Ut,_.state=Ot,_.info=Ie}B();let ut=new kf(
_,U);this.xr=ut,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let E=te.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=te.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return j},this.setPixelRatio=function(E){E!==void 0&&(j=E,this.setSize(
q,Z,!1))},this.getSize=function(E){return E.set(q,Z)},this.setSize=function(E,V,K=!0){if(ut.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=E,Z=V,e.width=Math.floor(E*j),e.height=Math.floor(V*j),K===!0&&(e.style.width=E+"px",e.style.height=V+"px"),this.setViewport(0,0,E,V)},this.getDrawingBufferSize=function(E){return E.set(q*j,Z*j).floor()},
this.setDrawingBufferSize=function(E,V,K){q=E,Z=V,j=K,e.width=Math.floor(E*K),e.height=Math.floor(V*K),this.setViewport(0,0,E,V)},this.getCurrentViewport=function(E){return E.copy(R)},this.getViewport=function(E){return E.copy(vt)},this.setViewport=function(E,V,K,$){E.isVector4?vt.set(E.x,E.y,E.z,E.w):vt.set(E,V,K,$),Ot.viewport(R.copy(vt).multiplyScalar(j).round())},this.getScissor=function(E){return E.
copy(bt)},this.setScissor=function(E,V,K,$){E.isVector4?bt.set(E.x,E.y,E.z,E.w):bt.set(E,V,K,$),Ot.scissor(O.copy(bt).multiplyScalar(j).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(E){Ot.setScissorTest(pt=E)},this.setOpaqueSort=function(E){rt=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(Rt.getClearColor())},this.setClearColor=
function(){Rt.setClearColor(...arguments)},this.getClearAlpha=function(){return Rt.getClearAlpha()},this.setClearAlpha=function(){Rt.setClearAlpha(...arguments)},this.clear=function(E=!0,V=!0,K=!0){let $=0;if(E){let G=!1;if(F!==null){let ft=F.texture.format;G=ft===kc||ft===Bc||ft===Oc}if(G){let ft=F.texture.type,Et=ft===Ci||ft===zs||ft===xo||ft===bo||ft===Uc||ft===Fc,Ft=Rt.getClearColor(),At=Rt.getClearAlpha(),
Jt=Ft.r,Qt=Ft.g,Wt=Ft.b;Et?(g[0]=Jt,g[1]=Qt,g[2]=Wt,g[3]=At,U.clearBufferuiv(U.COLOR,0,g)):(v[0]=Jt,v[1]=Qt,v[2]=Wt,v[3]=At,U.clearBufferiv(U.COLOR,0,v))}else $|=U.COLOR_BUFFER_BIT}V&&($|=U.DEPTH_BUFFER_BIT),K&&($|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=
function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",dt,!1),e.removeEventListener("webglcontextrestored",Dt,!1),e.removeEventListener("webglcontextcreationerror",ct,!1),Rt.dispose(),et.dispose(),Bt.dispose(),Lt.dispose(),Ge.dispose(),Ee.dispose(),N.dispose(),Mt.dispose(),ie.dispose(),J.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Ne),ut.
removeEventListener("sessionend",Yn),Hn.stop()};function dt(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),C=!0}function Dt(){console.log("THREE.WebGLRenderer: Context Restored."),C=!1;let E=Ie.autoReset,V=Ut.enabled,K=Ut.autoUpdate,$=Ut.needsUpdate,G=Ut.type;B(),Ie.autoReset=E,Ut.enabled=V,Ut.autoUpdate=K,Ut.needsUpdate=$,Ut.type=G}function ct(E){console.error("THREE.WebG\
LRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function st(E){let V=E.target;V.removeEventListener("dispose",st),Vt(V)}function Vt(E){re(E),Lt.remove(E)}function re(E){let V=Lt.get(E).programs;V!==void 0&&(V.forEach(function(K){J.releaseProgram(K)}),E.isShaderMaterial&&J.releaseShaderCache(E))}this.renderBufferDirect=function(E,V,K,$,G,ft){V===null&&(V=xt);let Et=G.isMesh&&
G.matrixWorld.determinant()<0,Ft=Zi(E,V,K,$,G);Ot.setMaterial($,Et);let At=K.index,Jt=1;if($.wireframe===!0){if(At=x.getWireframeAttribute(K),At===void 0)return;Jt=2}let Qt=K.drawRange,Wt=K.attributes.position,he=Qt.start*Jt,Me=(Qt.start+Qt.count)*Jt;ft!==null&&(he=Math.max(he,ft.start*Jt),Me=Math.min(Me,(ft.start+ft.count)*Jt)),At!==null?(he=Math.max(he,0),Me=Math.min(Me,At.count)):Wt!=null&&(he=
Math.max(he,0),Me=Math.min(Me,Wt.count));let ke=Me-he;if(ke<0||ke===1/0)return;Mt.setup(G,$,Ft,K,At);let Le,ae=gt;if(At!==null&&(Le=I.get(At),ae=Gt,ae.setIndex(Le)),G.isMesh)$.wireframe===!0?(Ot.setLineWidth($.wireframeLinewidth*Pe()),ae.setMode(U.LINES)):ae.setMode(U.TRIANGLES);else if(G.isLine){let $t=$.linewidth;$t===void 0&&($t=1),Ot.setLineWidth($t*Pe()),G.isLineSegments?ae.setMode(U.LINES):G.
isLineLoop?ae.setMode(U.LINE_LOOP):ae.setMode(U.LINE_STRIP)}else G.isPoints?ae.setMode(U.POINTS):G.isSprite&&ae.setMode(U.TRIANGLES);if(G.isBatchedMesh)if(G._multiDrawInstances!==null)so("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ae.renderMultiDrawInstances(G._multiDrawStarts,G._multiDrawCounts,
G._multiDrawCount,G._multiDrawInstances);else if(te.get("WEBGL_multi_draw"))ae.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let $t=G._multiDrawStarts,ze=G._multiDrawCounts,me=G._multiDrawCount,Cn=At?I.get(At).bytesPerElement:1,gs=Lt.get($).currentProgram.getUniforms();for(let Fn=0;Fn<me;Fn++)gs.setValue(U,"_gl_DrawID",Fn),ae.render($t[Fn]/Cn,ze[Fn])}else if(G.isInstancedMesh)
ae.renderInstances(he,ke,G.count);else if(K.isInstancedBufferGeometry){let $t=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,ze=Math.min(K.instanceCount,$t);ae.renderInstances(he,ke,ze)}else ae.render(he,ke)};function Ue(E,V,K){E.transparent===!0&&E.side===di&&E.forceSinglePass===!1?(E.side=zn,E.needsUpdate=!0,Ws(E,V,K),E.side=as,E.needsUpdate=!0,Ws(E,V,K),E.side=di):Ws(E,V,K)}this.compile=function(E,V,K=null){
K===null&&(K=E),p=Bt.get(K),p.init(V),T.push(p),K.traverseVisible(function(G){G.isLight&&G.layers.test(V.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),E!==K&&E.traverseVisible(function(G){G.isLight&&G.layers.test(V.layers)&&(p.pushLight(G),G.castShadow&&p.pushShadow(G))}),p.setupLights();let $=new Set;return E.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;
let ft=G.material;if(ft)if(Array.isArray(ft))for(let Et=0;Et<ft.length;Et++){let Ft=ft[Et];Ue(Ft,K,G),$.add(Ft)}else Ue(ft,K,G),$.add(ft)}),p=T.pop(),$},this.compileAsync=function(E,V,K=null){let $=this.compile(E,V,K);return new Promise(G=>{function ft(){if($.forEach(function(Et){Lt.get(Et).currentProgram.isReady()&&$.delete(Et)}),$.size===0){G(E);return}setTimeout(ft,10)}te.get("KHR_parallel_shad\
er_compile")!==null?ft():setTimeout(ft,10)})};let be=null;function Mn(E){be&&be(E)}function Ne(){Hn.stop()}function Yn(){Hn.start()}let Hn=new xg;Hn.setAnimationLoop(Mn),typeof self<"u"&&Hn.setContext(self),this.setAnimationLoop=function(E){be=E,ut.setAnimationLoop(E),E===null?Hn.stop():Hn.start()},ut.addEventListener("sessionstart",Ne),ut.addEventListener("sessionend",Yn),this.render=function(E,V){
if(V!==void 0&&V.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(V),V=ut.getCamera()),E.isScene===!0&&E.onBeforeRender(
_,E,V,F),p=Bt.get(E,T.length),p.init(V),T.push(p),tt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),se.setFromProjectionMatrix(tt,Ei,V.reversedDepth),Q=this.localClippingEnabled,Kt=ht.init(this.clippingPlanes,Q),m=et.get(E,b.length),m.init(),b.push(m),ut.enabled===!0&&ut.isPresenting===!0){let ft=_.xr.getDepthSensingMesh();ft!==null&&Ui(ft,V,-1/0,_.sortObjects)}Ui(E,V,0,_.sortObjects),m.
finish(),_.sortObjects===!0&&m.sort(rt,ot),ne=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,ne&&Rt.addToRenderList(m,E),this.info.render.frame++,Kt===!0&&ht.beginShadows();let K=p.state.shadowsArray;Ut.render(K,E,V),Kt===!0&&ht.endShadows(),this.info.autoReset===!0&&this.info.reset();let $=m.opaque,G=m.transmissive;if(p.setupLights(),V.isArrayCamera){let ft=V.cameras;if(G.length>
0)for(let Et=0,Ft=ft.length;Et<Ft;Et++){let At=ft[Et];$i($,G,E,At)}ne&&Rt.render(E);for(let Et=0,Ft=ft.length;Et<Ft;Et++){let At=ft[Et];Un(m,E,At,At.viewport)}}else G.length>0&&$i($,G,E,V),ne&&Rt.render(E),Un(m,E,V);F!==null&&D===0&&(qt.updateMultisampleRenderTarget(F),qt.updateRenderTargetMipmap(F)),E.isScene===!0&&E.onAfterRender(_,E,V),Mt.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.
length-1],Kt===!0&&ht.setGlobalState(_.clippingPlanes,p.state.camera)):p=null,b.pop(),b.length>0?m=b[b.length-1]:m=null};function Ui(E,V,K,$){if(E.visible===!1)return;if(E.layers.test(V.layers)){if(E.isGroup)K=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(V);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||se.intersectsSprite(E)){$&&
zt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(tt);let Et=N.update(E),Ft=E.material;Ft.visible&&m.push(E,Et,Ft,K,zt.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||se.intersectsObject(E))){let Et=N.update(E),Ft=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),zt.copy(E.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),
zt.copy(Et.boundingSphere.center)),zt.applyMatrix4(E.matrixWorld).applyMatrix4(tt)),Array.isArray(Ft)){let At=Et.groups;for(let Jt=0,Qt=At.length;Jt<Qt;Jt++){let Wt=At[Jt],he=Ft[Wt.materialIndex];he&&he.visible&&m.push(E,Et,he,K,zt.z,Wt)}}else Ft.visible&&m.push(E,Et,Ft,K,zt.z,null)}}let ft=E.children;for(let Et=0,Ft=ft.length;Et<Ft;Et++)Ui(ft[Et],V,K,$)}function Un(E,V,K,$){let G=E.opaque,ft=E.transmissive,
Et=E.transparent;p.setupLightsView(K),Kt===!0&&ht.setGlobalState(_.clippingPlanes,K),$&&Ot.viewport(R.copy($)),G.length>0&&vi(G,V,K),ft.length>0&&vi(ft,V,K),Et.length>0&&vi(Et,V,K),Ot.buffers.depth.setTest(!0),Ot.buffers.depth.setMask(!0),Ot.buffers.color.setMask(!0),Ot.setPolygonOffset(!1)}function $i(E,V,K,$){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[$.
id]===void 0&&(p.state.transmissionRenderTarget[$.id]=new Hi(1,1,{generateMipmaps:!0,type:te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float")?_o:Ci,minFilter:ks,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_e.workingColorSpace}));let ft=p.state.transmissionRenderTarget[$.id],Et=$.viewport||R;ft.setSize(Et.z*_.transmissionResolutionScale,Et.
w*_.transmissionResolutionScale);let Ft=_.getRenderTarget(),At=_.getActiveCubeFace(),Jt=_.getActiveMipmapLevel();_.setRenderTarget(ft),_.getClearColor(W),X=_.getClearAlpha(),X<1&&_.setClearColor(16777215,.5),_.clear(),ne&&Rt.render(K);let Qt=_.toneMapping;_.toneMapping=fs;let Wt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),p.setupLightsView($),Kt===!0&&ht.setGlobalState(_.clippingPlanes,
$),vi(E,K,$),qt.updateMultisampleRenderTarget(ft),qt.updateRenderTargetMipmap(ft),te.has("WEBGL_multisampled_render_to_texture")===!1){let he=!1;for(let Me=0,ke=V.length;Me<ke;Me++){let Le=V[Me],ae=Le.object,$t=Le.geometry,ze=Le.material,me=Le.group;if(ze.side===di&&ae.layers.test($.layers)){let Cn=ze.side;ze.side=zn,ze.needsUpdate=!0,ko(ae,K,$,$t,ze,me),ze.side=Cn,ze.needsUpdate=!0,he=!0}}he===!0&&
(qt.updateMultisampleRenderTarget(ft),qt.updateRenderTargetMipmap(ft))}_.setRenderTarget(Ft,At,Jt),_.setClearColor(W,X),Wt!==void 0&&($.viewport=Wt),_.toneMapping=Qt}function vi(E,V,K){let $=V.isScene===!0?V.overrideMaterial:null;for(let G=0,ft=E.length;G<ft;G++){let Et=E[G],Ft=Et.object,At=Et.geometry,Jt=Et.group,Qt=Et.material;Qt.allowOverride===!0&&$!==null&&(Qt=$),Ft.layers.test(K.layers)&&ko(
Ft,V,K,At,Qt,Jt)}}function ko(E,V,K,$,G,ft){E.onBeforeRender(_,V,K,$,G,ft),E.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),G.onBeforeRender(_,V,K,$,E,ft),G.transparent===!0&&G.side===di&&G.forceSinglePass===!1?(G.side=zn,G.needsUpdate=!0,_.renderBufferDirect(K,V,$,G,E,ft),G.side=as,G.needsUpdate=!0,_.renderBufferDirect(K,V,$,
G,E,ft),G.side=di):_.renderBufferDirect(K,V,$,G,E,ft),E.onAfterRender(_,V,K,$,G,ft)}function Ws(E,V,K){V.isScene!==!0&&(V=xt);let $=Lt.get(E),G=p.state.lights,ft=p.state.shadowsArray,Et=G.state.version,Ft=J.getParameters(E,G.state,ft,V,K),At=J.getProgramCacheKey(Ft),Jt=$.programs;$.environment=E.isMeshStandardMaterial?V.environment:null,$.fog=V.fog,$.envMap=(E.isMeshStandardMaterial?Ee:Ge).get(E.envMap||
$.environment),$.envMapRotation=$.environment!==null&&E.envMap===null?V.environmentRotation:E.envMapRotation,Jt===void 0&&(E.addEventListener("dispose",st),Jt=new Map,$.programs=Jt);let Qt=Jt.get(At);if(Qt!==void 0){if($.currentProgram===Qt&&$.lightsStateVersion===Et)return Ya(E,Ft),Qt}else Ft.uniforms=J.getUniforms(E),E.onBeforeCompile(Ft,_),Qt=J.acquireProgram(Ft,At),Jt.set(At,Qt),$.uniforms=Ft.
uniforms;let Wt=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Wt.clippingPlanes=ht.uniform),Ya(E,Ft),$.needsLights=Xs(E),$.lightsStateVersion=Et,$.needsLights&&(Wt.ambientLightColor.value=G.state.ambient,Wt.lightProbe.value=G.state.probe,Wt.directionalLights.value=G.state.directional,Wt.directionalLightShadows.value=G.state.directionalShadow,Wt.spotLights.value=
G.state.spot,Wt.spotLightShadows.value=G.state.spotShadow,Wt.rectAreaLights.value=G.state.rectArea,Wt.ltc_1.value=G.state.rectAreaLTC1,Wt.ltc_2.value=G.state.rectAreaLTC2,Wt.pointLights.value=G.state.point,Wt.pointLightShadows.value=G.state.pointShadow,Wt.hemisphereLights.value=G.state.hemi,Wt.directionalShadowMap.value=G.state.directionalShadowMap,Wt.directionalShadowMatrix.value=G.state.directionalShadowMatrix,
Wt.spotShadowMap.value=G.state.spotShadowMap,Wt.spotLightMatrix.value=G.state.spotLightMatrix,Wt.spotLightMap.value=G.state.spotLightMap,Wt.pointShadowMap.value=G.state.pointShadowMap,Wt.pointShadowMatrix.value=G.state.pointShadowMatrix),$.currentProgram=Qt,$.uniformsList=null,Qt}function qa(E){if(E.uniformsList===null){let V=E.currentProgram.getUniforms();E.uniformsList=Eo.seqWithValue(V.seq,E.uniforms)}
return E.uniformsList}function Ya(E,V){let K=Lt.get(E);K.outputColorSpace=V.outputColorSpace,K.batching=V.batching,K.batchingColor=V.batchingColor,K.instancing=V.instancing,K.instancingColor=V.instancingColor,K.instancingMorph=V.instancingMorph,K.skinning=V.skinning,K.morphTargets=V.morphTargets,K.morphNormals=V.morphNormals,K.morphColors=V.morphColors,K.morphTargetsCount=V.morphTargetsCount,K.numClippingPlanes=
V.numClippingPlanes,K.numIntersection=V.numClipIntersection,K.vertexAlphas=V.vertexAlphas,K.vertexTangents=V.vertexTangents,K.toneMapping=V.toneMapping}function Zi(E,V,K,$,G){V.isScene!==!0&&(V=xt),qt.resetTextureUnits();let ft=V.fog,Et=$.isMeshStandardMaterial?V.environment:null,Ft=F===null?_.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:rr,At=($.isMeshStandardMaterial?Ee:Ge).get(
$.envMap||Et),Jt=$.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,Qt=!!K.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Wt=!!K.morphAttributes.position,he=!!K.morphAttributes.normal,Me=!!K.morphAttributes.color,ke=fs;$.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(ke=_.toneMapping);let Le=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,
ae=Le!==void 0?Le.length:0,$t=Lt.get($),ze=p.state.lights;if(Kt===!0&&(Q===!0||E!==S)){let dn=E===S&&$.id===w;ht.setState($,E,dn)}let me=!1;$.version===$t.__version?($t.needsLights&&$t.lightsStateVersion!==ze.state.version||$t.outputColorSpace!==Ft||G.isBatchedMesh&&$t.batching===!1||!G.isBatchedMesh&&$t.batching===!0||G.isBatchedMesh&&$t.batchingColor===!0&&G.colorTexture===null||G.isBatchedMesh&&
$t.batchingColor===!1&&G.colorTexture!==null||G.isInstancedMesh&&$t.instancing===!1||!G.isInstancedMesh&&$t.instancing===!0||G.isSkinnedMesh&&$t.skinning===!1||!G.isSkinnedMesh&&$t.skinning===!0||G.isInstancedMesh&&$t.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&$t.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&$t.instancingMorph===!0&&G.morphTexture===null||G.
isInstancedMesh&&$t.instancingMorph===!1&&G.morphTexture!==null||$t.envMap!==At||$.fog===!0&&$t.fog!==ft||$t.numClippingPlanes!==void 0&&($t.numClippingPlanes!==ht.numPlanes||$t.numIntersection!==ht.numIntersection)||$t.vertexAlphas!==Jt||$t.vertexTangents!==Qt||$t.morphTargets!==Wt||$t.morphNormals!==he||$t.morphColors!==Me||$t.toneMapping!==ke||$t.morphTargetsCount!==ae)&&(me=!0):(me=!0,$t.__version=
$.version);let Cn=$t.currentProgram;me===!0&&(Cn=Ws($,V,G));let gs=!1,Fn=!1,qs=!1,Ve=Cn.getUniforms(),Nn=$t.uniforms;if(Ot.useProgram(Cn.program)&&(gs=!0,Fn=!0,qs=!0),$.id!==w&&(w=$.id,Fn=!0),gs||S!==E){Ot.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),Ve.setValue(U,"projectionMatrix",E.projectionMatrix),Ve.setValue(U,"viewMatrix",E.matrixWorldInverse);
let pn=Ve.map.cameraPosition;pn!==void 0&&pn.setValue(U,wt.setFromMatrixPosition(E.matrixWorld)),Yt.logarithmicDepthBuffer&&Ve.setValue(U,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Ve.setValue(U,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,Fn=
!0,qs=!0)}if(G.isSkinnedMesh){Ve.setOptional(U,G,"bindMatrix"),Ve.setOptional(U,G,"bindMatrixInverse");let dn=G.skeleton;dn&&(dn.boneTexture===null&&dn.computeBoneTexture(),Ve.setValue(U,"boneTexture",dn.boneTexture,qt))}G.isBatchedMesh&&(Ve.setOptional(U,G,"batchingTexture"),Ve.setValue(U,"batchingTexture",G._matricesTexture,qt),Ve.setOptional(U,G,"batchingIdTexture"),Ve.setValue(U,"batchingIdTex\
ture",G._indirectTexture,qt),Ve.setOptional(U,G,"batchingColorTexture"),G._colorsTexture!==null&&Ve.setValue(U,"batchingColorTexture",G._colorsTexture,qt));let Gn=K.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&at.update(G,K,Cn),(Fn||$t.receiveShadow!==G.receiveShadow)&&($t.receiveShadow=G.receiveShadow,Ve.setValue(U,"receiveShadow",G.receiveShadow)),$.isMeshGouraudMaterial&&
$.envMap!==null&&(Nn.envMap.value=At,Nn.flipEnvMap.value=At.isCubeTexture&&At.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&V.environment!==null&&(Nn.envMapIntensity.value=V.environmentIntensity),Fn&&(Ve.setValue(U,"toneMappingExposure",_.toneMappingExposure),$t.needsLights&&Xh(Nn,qs),ft&&$.fog===!0&&nt.refreshFogUniforms(Nn,ft),nt.refreshMaterialUniforms(Nn,$,j,Z,p.state.
transmissionRenderTarget[E.id]),Eo.upload(U,qa($t),Nn,qt)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Eo.upload(U,qa($t),Nn,qt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Ve.setValue(U,"center",G.center),Ve.setValue(U,"modelViewMatrix",G.modelViewMatrix),Ve.setValue(U,"normalMatrix",G.normalMatrix),Ve.setValue(U,"modelMatrix",G.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){let dn=$.
uniformsGroups;for(let pn=0,vs=dn.length;pn<vs;pn++){let oi=dn[pn];ie.update(oi,Cn),ie.bind(oi,Cn)}}return Cn}function Xh(E,V){E.ambientLightColor.needsUpdate=V,E.lightProbe.needsUpdate=V,E.directionalLights.needsUpdate=V,E.directionalLightShadows.needsUpdate=V,E.pointLights.needsUpdate=V,E.pointLightShadows.needsUpdate=V,E.spotLights.needsUpdate=V,E.spotLightShadows.needsUpdate=V,E.rectAreaLights.
needsUpdate=V,E.hemisphereLights.needsUpdate=V}function Xs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(E,V,K){let $=Lt.
get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Lt.get(E.texture).__webglTexture=V,Lt.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:K,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,V){let K=Lt.get(E);K.__webglFramebuffer=V,K.__useDefaultFramebuffer=V===void 0};let $a=U.createFramebuffer();
this.setRenderTarget=function(E,V=0,K=0){F=E,A=V,D=K;let $=!0,G=null,ft=!1,Et=!1;if(E){let At=Lt.get(E);if(At.__useDefaultFramebuffer!==void 0)Ot.bindFramebuffer(U.FRAMEBUFFER,null),$=!1;else if(At.__webglFramebuffer===void 0)qt.setupRenderTarget(E);else if(At.__hasExternalTextures)qt.rebindTextures(E,Lt.get(E.texture).__webglTexture,Lt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Wt=E.
depthTexture;if(At.__boundDepthTexture!==Wt){if(Wt!==null&&Lt.has(Wt)&&(E.width!==Wt.image.width||E.height!==Wt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(E)}}let Jt=E.texture;(Jt.isData3DTexture||Jt.isDataArrayTexture||Jt.isCompressedArrayTexture)&&(Et=!0);let Qt=Lt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?
(Array.isArray(Qt[V])?G=Qt[V][K]:G=Qt[V],ft=!0):E.samples>0&&qt.useMultisampledRTT(E)===!1?G=Lt.get(E).__webglMultisampledFramebuffer:Array.isArray(Qt)?G=Qt[K]:G=Qt,R.copy(E.viewport),O.copy(E.scissor),z=E.scissorTest}else R.copy(vt).multiplyScalar(j).floor(),O.copy(bt).multiplyScalar(j).floor(),z=pt;if(K!==0&&(G=$a),Ot.bindFramebuffer(U.FRAMEBUFFER,G)&&$&&Ot.drawBuffers(E,G),Ot.viewport(R),Ot.scissor(
O),Ot.setScissorTest(z),ft){let At=Lt.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+V,At.__webglTexture,K)}else if(Et){let At=V;for(let Jt=0;Jt<E.textures.length;Jt++){let Qt=Lt.get(E.textures[Jt]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Jt,Qt.__webglTexture,K,At)}}else if(E!==null&&K!==0){let At=Lt.get(E.texture);U.framebufferTexture2D(
U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,At.__webglTexture,K)}w=-1},this.readRenderTargetPixels=function(E,V,K,$,G,ft,Et,Ft=0){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let At=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Et!==void 0&&(At=At[Et]),At){Ot.bindFramebuffer(U.FRAMEBUFFER,
At);try{let Jt=E.textures[Ft],Qt=Jt.format,Wt=Jt.type;if(!Yt.textureFormatReadable(Qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Yt.textureTypeReadable(Wt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=E.
width-$&&K>=0&&K<=E.height-G&&(E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ft),U.readPixels(V,K,$,G,Ht.convert(Qt),Ht.convert(Wt),ft))}finally{let Jt=F!==null?Lt.get(F).__webglFramebuffer:null;Ot.bindFramebuffer(U.FRAMEBUFFER,Jt)}}},this.readRenderTargetPixelsAsync=async function(E,V,K,$,G,ft,Et,Ft=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPix\
els: renderTarget is not THREE.WebGLRenderTarget.");let At=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Et!==void 0&&(At=At[Et]),At)if(V>=0&&V<=E.width-$&&K>=0&&K<=E.height-G){Ot.bindFramebuffer(U.FRAMEBUFFER,At);let Jt=E.textures[Ft],Qt=Jt.format,Wt=Jt.type;if(!Yt.textureFormatReadable(Qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA \
or implementation defined format.");if(!Yt.textureTypeReadable(Wt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let he=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,he),U.bufferData(U.PIXEL_PACK_BUFFER,ft.byteLength,U.STREAM_READ),E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ft),U.readPixels(
V,K,$,G,Ht.convert(Qt),Ht.convert(Wt),0);let Me=F!==null?Lt.get(F).__webglFramebuffer:null;Ot.bindFramebuffer(U.FRAMEBUFFER,Me);let ke=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await qm(U,ke,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,he),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,ft),U.deleteBuffer(he),U.deleteSync(ke),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAs\
ync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,V=null,K=0){let $=Math.pow(2,-K),G=Math.floor(E.image.width*$),ft=Math.floor(E.image.height*$),Et=V!==null?V.x:0,Ft=V!==null?V.y:0;qt.setTexture2D(E,0),U.copyTexSubImage2D(U.TEXTURE_2D,K,0,0,Et,Ft,G,ft),Ot.unbindTexture()};let Fi=U.createFramebuffer(),ln=U.createFramebuffer();this.copyTextureToTexture=function(E,V,K=null,$=null,G=0,ft=null){
ft===null&&(G!==0?(so("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),ft=G,G=0):ft=0);let Et,Ft,At,Jt,Qt,Wt,he,Me,ke,Le=E.isCompressedTexture?E.mipmaps[ft]:E.image;if(K!==null)Et=K.max.x-K.min.x,Ft=K.max.y-K.min.y,At=K.isBox3?K.max.z-K.min.z:1,Jt=K.min.x,Qt=K.min.y,Wt=K.isBox3?K.min.z:0;else{let Gn=Math.pow(2,-G);Et=Math.floor(Le.width*Gn),
Ft=Math.floor(Le.height*Gn),E.isDataArrayTexture?At=Le.depth:E.isData3DTexture?At=Math.floor(Le.depth*Gn):At=1,Jt=0,Qt=0,Wt=0}$!==null?(he=$.x,Me=$.y,ke=$.z):(he=0,Me=0,ke=0);let ae=Ht.convert(V.format),$t=Ht.convert(V.type),ze;V.isData3DTexture?(qt.setTexture3D(V,0),ze=U.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(qt.setTexture2DArray(V,0),ze=U.TEXTURE_2D_ARRAY):(qt.setTexture2D(
V,0),ze=U.TEXTURE_2D),U.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,V.flipY),U.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),U.pixelStorei(U.UNPACK_ALIGNMENT,V.unpackAlignment);let me=U.getParameter(U.UNPACK_ROW_LENGTH),Cn=U.getParameter(U.UNPACK_IMAGE_HEIGHT),gs=U.getParameter(U.UNPACK_SKIP_PIXELS),Fn=U.getParameter(U.UNPACK_SKIP_ROWS),qs=U.getParameter(U.UNPACK_SKIP_IMAGES);U.pixelStorei(
U.UNPACK_ROW_LENGTH,Le.width),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Le.height),U.pixelStorei(U.UNPACK_SKIP_PIXELS,Jt),U.pixelStorei(U.UNPACK_SKIP_ROWS,Qt),U.pixelStorei(U.UNPACK_SKIP_IMAGES,Wt);let Ve=E.isDataArrayTexture||E.isData3DTexture,Nn=V.isDataArrayTexture||V.isData3DTexture;if(E.isDepthTexture){let Gn=Lt.get(E),dn=Lt.get(V),pn=Lt.get(Gn.__renderTarget),vs=Lt.get(dn.__renderTarget);Ot.bindFramebuffer(
U.READ_FRAMEBUFFER,pn.__webglFramebuffer),Ot.bindFramebuffer(U.DRAW_FRAMEBUFFER,vs.__webglFramebuffer);for(let oi=0;oi<At;oi++)Ve&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Lt.get(E).__webglTexture,G,Wt+oi),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Lt.get(V).__webglTexture,ft,ke+oi)),U.blitFramebuffer(Jt,Qt,Et,Ft,he,Me,Et,Ft,U.DEPTH_BUFFER_BIT,U.NEAREST);
Ot.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ot.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(G!==0||E.isRenderTargetTexture||Lt.has(E)){let Gn=Lt.get(E),dn=Lt.get(V);Ot.bindFramebuffer(U.READ_FRAMEBUFFER,Fi),Ot.bindFramebuffer(U.DRAW_FRAMEBUFFER,ln);for(let pn=0;pn<At;pn++)Ve?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Gn.__webglTexture,G,Wt+pn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,
U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Gn.__webglTexture,G),Nn?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,dn.__webglTexture,ft,ke+pn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,dn.__webglTexture,ft),G!==0?U.blitFramebuffer(Jt,Qt,Et,Ft,he,Me,Et,Ft,U.COLOR_BUFFER_BIT,U.NEAREST):Nn?U.copyTexSubImage3D(ze,ft,he,Me,ke+pn,Jt,Qt,Et,Ft):U.copyTexSubImage2D(ze,
ft,he,Me,Jt,Qt,Et,Ft);Ot.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ot.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Nn?E.isDataTexture||E.isData3DTexture?U.texSubImage3D(ze,ft,he,Me,ke,Et,Ft,At,ae,$t,Le.data):V.isCompressedArrayTexture?U.compressedTexSubImage3D(ze,ft,he,Me,ke,Et,Ft,At,ae,Le.data):U.texSubImage3D(ze,ft,he,Me,ke,Et,Ft,At,ae,$t,Le):E.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,ft,he,Me,
Et,Ft,ae,$t,Le.data):E.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,ft,he,Me,Le.width,Le.height,ae,Le.data):U.texSubImage2D(U.TEXTURE_2D,ft,he,Me,Et,Ft,ae,$t,Le);U.pixelStorei(U.UNPACK_ROW_LENGTH,me),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Cn),U.pixelStorei(U.UNPACK_SKIP_PIXELS,gs),U.pixelStorei(U.UNPACK_SKIP_ROWS,Fn),U.pixelStorei(U.UNPACK_SKIP_IMAGES,qs),ft===0&&V.generateMipmaps&&U.generateMipmap(
ze),Ot.unbindTexture()},this.initRenderTarget=function(E){Lt.get(E).__webglFramebuffer===void 0&&qt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?qt.setTextureCube(E,0):E.isData3DTexture?qt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?qt.setTexture2DArray(E,0):qt.setTexture2D(E,0),Ot.unbindTexture()},this.resetState=function(){A=0,D=0,F=null,Ot.reset(),Mt.
reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ei}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};function wg(i,t=Math.PI/3){let e=Math.cos(t),n=(1+1e-10)*100,s=[new H,new H,new H],r=new H,o=new H,a=new H,l=new H;function c(v){let m=~~(v.x*n),p=~~(v.y*n),b=~~(v.z*n);return`${m},${p},${b}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,m=h.count/3;v<m;v++){let p=3*v,b=s[0].fromBufferAttribute(h,p+0),T=s[1].fromBufferAttribute(h,p+1),_=s[2].fromBufferAttribute(h,p+2);r.
subVectors(_,T),o.subVectors(b,T);let C=new H().crossVectors(r,o).normalize();for(let A=0;A<3;A++){let D=s[A],F=c(D);F in f||(f[F]=[]),f[F].push(C)}}let d=new Float32Array(h.count*3),g=new Ln(d,3,!1);for(let v=0,m=h.count/3;v<m;v++){let p=3*v,b=s[0].fromBufferAttribute(h,p+0),T=s[1].fromBufferAttribute(h,p+1),_=s[2].fromBufferAttribute(h,p+2);r.subVectors(_,T),o.subVectors(b,T),a.crossVectors(r,o).
normalize();for(let C=0;C<3;C++){let A=s[C],D=c(A),F=f[D];l.set(0,0,0);for(let w=0,S=F.length;w<S;w++){let R=F[w];a.dot(R)>e&&l.add(R)}l.normalize(),g.setXYZ(p+C,l.x,l.y,l.z)}}return u.setAttribute("normal",g),u}function Vs(i,t,e=.8){let n=i.index?i.toNonIndexed():i,s=n.getAttribute("position"),r=new Float32Array(3*s.count);for(let o=0;o<s.count;o+=3){let a=c=>(c(o)+c(o+1)+c(o+2))/3,l=t(a(c=>s.getX(c)),a(c=>s.getY(c)),a(c=>s.getZ(c)))?e:1;r.fill(l,3*o,3*o+9)}return n.setAttribute("color",new pe(r,3)),n}function Tg(i){if(!i)return Vs(new mo(1,40,24),(s,r,o)=>s*r*o>0);let t=new mo(1,10,7),e=t.getAttribute("\
position"),n=Array.from({length:e.count},(s,r)=>e.getX(r)*e.getY(r)*e.getZ(r)>.01?.72:1);return t.setAttribute("color",new pe(n.flatMap(s=>[s,s,s]),3)),t}function Vf(){let i=new fo(1,1,2,48).applyMatrix4(new de().makeRotationX(Math.PI/2));return Vs(i,(t,e)=>t*e>0)}function Ag(i,t){let e=new xa(i,2*t,12,28).applyMatrix4(new de().makeRotationX(Math.PI/2));return Vs(e,(n,s)=>n*s>0)}function Cg(){let i=new _a(
1,2,48).applyMatrix4(new de().makeRotationX(Math.PI/2).setPosition(0,0,1));return Vs(i,(t,e)=>t*e>0)}function Rg(i,t){return Vs(new Ma(i,t,20,64),(e,n)=>e*n>0)}var GS=400,Eg=30;function Pg({points:i=[],triangles:t=[]}){let e=new Qe,n=t.flatMap(o=>o.flatMap(a=>i[a]));e.setAttribute("position",new pe(n,3)),e.computeVertexNormals();let s=t.length>GS,r=s?wg(e,Eg*Math.PI/180):e;return{solid:Vs(r,()=>!1),
edges:new po(e,s?Eg:12)}}function Ig(){return Vs(new hs(2,2,2),()=>!1)}function Lg(){return new po(new hs(2,2,2))}function Dg(){let e=new Float32Array(435);for(let n=0;n<=144;++n){let s=n/144,r=2*Math.PI*9*s,o=Math.min(1,12*Math.min(s,1-s));e.set([o*Math.cos(r),o*Math.sin(r),s],3*n)}return e}function Ug(i,t){let e=[0,0,0],n=0;for(let a=0;a<i.length;++a){let l=i[a],c=i[(a+1)%i.length];e=_t(e,rn(l,c)),
n+=xn(Zt(c,l))}let s=Kn(e),r=yt(i.reduce(_t,[0,0,0]),1/i.length),o=xn(e)/Math.max(n,1e-12);for(let a of t)WS(r,a)&&(o=Math.max(o,1.08*a.thickness));return{points:i,n:s,thickness:o}}function WS(i,t){let{points:e,n}=t,s=Math.max(...e.map(r=>xn(Zt(r,e[0]))));return Math.abs(It(n,Zt(i,e[0])))>.02*s?!1:e.every((r,o)=>It(n,rn(Zt(e[(o+1)%e.length],r),Zt(i,r)))>=0)}function Fg({points:i,n:t,thickness:e}){
let n=yt(t,e/2),s=[],r=[],o=i.map(u=>_t(u,n)),a=i.map(u=>Zt(u,n));for(let u=1;u+1<i.length;++u)s.push(...o[0],...o[u],...o[u+1],...a[0],...a[u+1],...a[u]);for(let u=0;u<i.length;++u){let h=(u+1)%i.length;s.push(...o[u],...a[u],...a[h],...o[u],...a[h],...o[h]),r.push(...o[u],...o[h],...a[u],...a[h])}let l=new Qe,c=new Qe;return l.setAttribute("position",new pe(s,3)),l.computeVertexNormals(),c.setAttribute(
"position",new pe(r,3)),{solid:Vs(l,()=>!1),edges:c}}function bh(i,t,e){let n=Zt(t,i),s=Kn(n),r=Kn(rn(Math.abs(s[0])<.9?[1,0,0]:[0,1,0],s)),o=rn(s,r),a=yt(_t(i,t),.5),l=xn(n)/2,[c,u,h]=[yt(r,e),yt(o,e),yt(s,l)];return new de().set(c[0],u[0],h[0],a[0],c[1],u[1],h[1],a[1],c[2],u[2],h[2],a[2],0,0,0,1)}function Ng(i,t){return i.kind==="capsule"?`capsule ${i.radius} ${i.halfLength}`:i.kind==="torus"?`t\
orus ${i.radius} ${i.tube}`:i.kind==="polygon"||i.kind==="mesh"?`${i.kind} ${t}`:i.kind==="ellipsoid"?"sphere":i.kind==="circle"?"cylinder":i.kind}var XS=1500,Mh=class{constructor(t,e,n){this.model=e;this.scene=new pa;this.eye=new In;this.flat=new ur;this.groups=[];this.links=[];this.grounds=[];this.sun=new Ea(16777215,1.9);this.fill=new wa(16777215,12107976,1.3);this.ambient=new Ta(16777215,.55);this.used=this.eye;this.marked=-2;this.hidden=new Set;let{canvas:s,context:r,software:o}=YS(t,n);this.canvas=s,this.renderer=new xh({canvas:s,context:r,
antialias:!o,preserveDrawingBuffer:!0}),this.renderer.debug.checkShaderErrors=n,this.frames=Array.from({length:e.film.poses},()=>new de);let a=o||e.bodies.length>XS;this.renderer.shadowMap.enabled=!a,this.renderer.shadowMap.type=Mc,this.sun.castShadow=!a,this.sun.shadow.mapSize.set(2048,2048),this.sun.shadow.normalBias=.004*e.extent.size,this.sun.shadow.radius=4,this.scene.add(this.sun,this.sun.target,
this.fill,this.ambient),this.addBodies(a,e.bodies.length>200);for(let l of e.grounds)this.addGround(l,a);this.recolour()}addBodies(t,e){let n=new Map,s=new Map,r=(o,a)=>{let l=n.get(o);l?l.push(a):n.set(o,[a])};this.model.bodies.forEach((o,a)=>{if(o.kind==="link")this.addLink(o);else if(o.kind==="segment")for(let l of this.bars(o))r("cylinder",{frame:o.frame,local:l,shape:o});else r(Ng(o,a),{frame:o.
frame,local:$S(o),shape:o})});for(let[o,a]of n){let{shape:l}=a[0],c=null,u;if(o==="sphere")u=Tg(t&&e);else if(o==="box")u=Ig(),c=Lg();else if(o==="cylinder")u=Vf();else if(o==="cone")u=Cg();else if(l.kind==="torus")u=Rg(l.radius??0,l.tube??0);else if(l.kind==="mesh")({solid:u,edges:c}=Pg(l));else if(l.kind==="capsule")u=Ag(l.radius??0,l.halfLength??0);else{let h=s.get(l.frame)??[],f=Ug(l.points??[],
h);s.set(l.frame,[...h,f]),{solid:u,edges:c}=Fg(f)}this.addGroup(a,u,c,t)}}addGroup(t,e,n,s){let r=s?new cr({vertexColors:!0}):new go({vertexColors:!0,roughness:.62,metalness:0,side:di}),o=new ma(e,r,t.length);o.frustumCulled=!1,o.castShadow=o.receiveShadow=!s;let a=n&&t.length<=300?t.map(()=>new lr(n,Na({transparent:!0,opacity:.55}))):[];for(let u of a)u.matrixAutoUpdate=!1,u.frustumCulled=!1;this.
scene.add(o,...a);let l=t.some(u=>this.model.film.moves(u.frame)),c=l&&t.every(({frame:u,shape:h})=>u>=0&&h.kind==="sphere"&&h.position.every(f=>f===0)&&h.orientation[0]===1);this.groups.push({mesh:o,instances:t,moving:l,edges:a,balls:c}),this.place(this.groups[this.groups.length-1])}bars(t){let e=t.points??[],n=[],s=Gf(t.position,t.orientation),r=e.slice(1).reduce((a,l,c)=>a+Math.hypot(l[0]-e[c][0],
l[1]-e[c][1],l[2]-e[c][2]),0),o=t.radius||Math.min(.0022*this.model.extent.size,.01*r);for(let a=0;a+1<e.length;++a)n.push(new de().multiplyMatrices(s,bh(e[a],e[a+1],o)));return n}addLink(t){let e;if(t.style==="spring"){let n=new Qe().setAttribute("position",new pe(Dg(),3));e=new ar(n,Na())}else e=new An(Vf(),new go({vertexColors:!0,roughness:.6})),e.castShadow=!0;e.matrixAutoUpdate=!1,e.frustumCulled=
!1,this.scene.add(e),this.links.push({shape:t,object:e})}remeasured(){for(let{sheet:t,lines:e,outline:n,near:s}of this.grounds.splice(0))this.scene.remove(t,e,n,s);for(let t of this.model.grounds)this.addGround(t,!this.renderer.shadowMap.enabled);this.sun.shadow.normalBias=.004*this.model.extent.size,this.recolour()}addGround(t,e){let{begin:n}=this.model.film,{outline:s,lines:r}=this.model.sheet(t,
n,.9,14);if(s.length<3)return;let o=f=>new Qe().setAttribute("position",new pe(f.flat(),3)),a={polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:4},l=o(s);l.setIndex(s.slice(2).flatMap((f,d)=>[0,d+1,d+2]));let{n:c}=this.model.plane(t,n);l.setAttribute("normal",new pe(s.flatMap(()=>c),3));let u=new An(l,e?new or(a):new cr(a));u.receiveShadow=!e;let h={sheet:u,lines:new lr(o(r.flat()),Na()),
outline:new ga(o(s),Na()),shape:t,made:new de,near:new lr(new Qe,Na()),seen:""};if(t.frame>=0){let{r:f,q:d}=this.model.film.pose(t.frame,n);h.made.copy(Gf(f,d)).invert()}for(let f of[u,h.lines,h.outline,h.near])f.matrixAutoUpdate=!1,f.frustumCulled=!1;this.scene.add(u,h.lines,h.outline,h.near),this.grounds.push(h)}placeGrounds(t,e){for(let n of this.grounds){let{sheet:s,lines:r,outline:o,shape:a,made:l,
near:c}=n;if(a.frame>=0)for(let d of[s,r,o])d.matrix.multiplyMatrices(this.frames[a.frame],l),d.matrixWorldNeedsUpdate=!0;let{c:u,n:h}=this.model.plane(a,e),f=t.hasDepth?t.distance:1e3*this.model.extent.size;r.visible=It(h,Zt(_t(t.centre,yt(t.toward,f)),u))>0,c.visible=r.visible&&this.stands(a,e)&&this.lookedAt(n,t,e)}}stands({frame:t},e){if(t<0)return!0;let{film:n}=this.model,s=n.pose(t,n.begin),
r=n.pose(t,e);return s.r.every((o,a)=>o===r.r[a])&&s.q.every((o,a)=>o===r.q[a])}lookedAt(t,e,n){let s=1.5*Math.max(e.width,e.height)/e.scale;if(s>.3*this.model.extent.size)return!1;let r=e.centre.map(l=>Math.round(4*l/s)),o=`${s.toPrecision(3)} ${r.join(" ")}`;if(o===t.seen)return!0;t.seen=o;let{lines:a}=this.model.sheetAround(t.shape,n,r.map(l=>l*s/4),s,14);return t.near.geometry.dispose(),t.near.
geometry=new Qe().setAttribute("position",new pe(a.flat(2),3)),!0}recolour(t=this.marked){this.marked=t,this.renderer.setClearColor(jt.paper);let e=jt.dark?.25:-.45,n=new ce(jt.accent),s=new ce;for(let{mesh:r,instances:o,edges:a}of this.groups)o.forEach(({shape:l,frame:c},u)=>{let h=Es(l);s.set(h),c>=0&&c===t&&s.lerp(n,.75),r.setColorAt(u,s),a[u]&&a[u].material.color.set(Ye(h,e))}),r.instanceColor&&
(r.instanceColor.needsUpdate=!0);for(let{shape:r,object:o}of this.links)o.material.color.set(Ye(Es(r),-.2));for(let{sheet:r,lines:o,outline:a,near:l}of this.grounds){let c=r.material instanceof cr;r.material.color.set(jt.dark?"#2a323b":c?"#dfe4e9":"#e7edf4");for(let u of[o,a,l])u.material.color.set(jt.groundLine)}this.fill.intensity=jt.dark?1.1:1.6}dispose(){this.renderer.dispose(),this.renderer.forceContextLoss()}resize(t,e,n){
this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1)}place(t){let e=new de;t.balls&&!this.hidden.size?qS(t,this.model.film.now):t.instances.forEach(({frame:n,local:s},r)=>{this.hidden.has(n)?e.makeScale(0,0,0):n>=0?e.multiplyMatrices(this.frames[n],s):e.copy(s),t.mesh.setMatrixAt(r,e),t.edges[r]&&t.edges[r].matrix.copy(e)}),t.mesh.instanceMatrix.needsUpdate=!0,t.mesh.boundingSphere=null}hide(t){
this.hidden=t;for(let e of this.groups)this.place(e);for(let{shape:e,object:n}of this.links)n.visible=!t.has(e.frame)}draw(t,e,n){n!==this.marked&&this.recolour(n);let s=this.model.film.sample(e);this.frames.forEach((r,o)=>KS(r,s,7*o));for(let r of this.groups)r.moving&&this.place(r);for(let{shape:r,object:o}of this.links)this.placeLink(r,o,e);this.placeGrounds(t,e),this.aim(t),this.renderer.render(
this.scene,this.used)}placeLink(t,e,n){let[s,r]=[this.model.film.pose(t.frame,n),this.model.film.pose(t.frameEnd??-1,n)],[o,a]=t.points??[],l=!this.model.absent(t,n);if(e.visible=l&&!this.hidden.has(t.frame),!l)return;let c=_t(s.r,je(s.q,o??[0,0,0])),u=_t(r.r,je(r.q,a??[0,0,0])),h=this.model.extent.size;t.style==="spring"?e.matrix.copy(bh(Zt(yt(c,2),u),u,.018*h)):e.matrix.copy(bh(c,u,t.radius||.0025*
h))}aim(t){let e=Math.max(this.model.extent.size,.5*t.height/t.scale),n=t.hasDepth?t.distance:3*e,s=t.hasDepth?this.eye:this.flat;if(s.position.set(..._t(t.centre,yt(t.toward,n))),s.up.set(...t.up),s.lookAt(...t.centre),s===this.eye)this.eye.fov=Su*180/Math.PI,this.eye.aspect=t.width/t.height,this.eye.near=Math.max(.02*n,n-4*e),this.eye.far=n+6*e,this.eye.updateProjectionMatrix();else{let[h,f]=[t.
width/t.scale/2,t.height/t.scale/2];Object.assign(this.flat,{left:-h,right:h,top:f,bottom:-f,near:.01*e,far:8*e}),this.flat.updateProjectionMatrix()}this.used=s;let r=t.upAxis===1?[0,1,0]:[0,0,1],o=t.isPlanar?_t(yt(t.toward,1.2),_t(yt(t.up,.9),yt(t.right,-.5))):_t(yt(t.toward,.55),_t(yt(r,1.15),yt(t.right,-.55))),{lo:a,hi:l}=this.model.extent,c=e>4/t.scale*t.height?t.centre:yt(_t(a,l),.5),u=Math.min(
.75*e,.9*t.width/t.scale);this.sun.target.position.set(...c),this.sun.target.updateMatrixWorld(),this.sun.position.set(..._t(c,yt(o,2*e))),Object.assign(this.sun.shadow.camera,{left:-u,right:u,top:u,bottom:-u,near:.1*e,far:6*e}),this.sun.shadow.camera.updateProjectionMatrix()}pick(t,e,n){return this.hit(t,e,n).frame}hit(t,e,n){let s=new Aa;s.setFromCamera(new ge(2*e/t.width-1,1-2*n/t.height),this.
used);let r=1/0,o=-2,a=[0,0,0];for(let{mesh:l,instances:c}of this.groups)for(let u of s.intersectObject(l,!1))u.distance<r&&u.instanceId!==void 0&&(r=u.distance,o=c[u.instanceId].frame,a=u.point.toArray());return{frame:o,point:a}}};function qS({mesh:i,instances:t},e){let n=i.instanceMatrix.array;for(let s=0;s<t.length;++s){let r=7*t[s].frame,o=t[s].shape.radius??1,a=16*s,l=e[r+3],c=e[r+4],u=e[r+5],
h=e[r+6];if(l===0&&c===0&&u===0&&h===0){n.fill(0,a,a+16),n[a+15]=1;continue}n[a]=o*(1-2*(u*u+h*h)),n[a+1]=2*o*(c*u+l*h),n[a+2]=2*o*(c*h-l*u),n[a+4]=2*o*(c*u-l*h),n[a+5]=o*(1-2*(c*c+h*h)),n[a+6]=2*o*(u*h+l*c),n[a+8]=2*o*(c*h+l*u),n[a+9]=2*o*(u*h-l*c),n[a+10]=o*(1-2*(c*c+u*u)),n[a+12]=e[r],n[a+13]=e[r+1],n[a+14]=e[r+2],n[a+15]=1}}function Na(i={}){return Object.assign(new uo(i),{combine:yo})}function YS(i,t){
let e=(a,l)=>{let c=a.getContext("webgl2",{preserveDrawingBuffer:!0,stencil:!1,antialias:l});if(!c)throw new Error("no WebGL");return c};i.width=innerWidth,i.height=innerHeight;let n=e(i,t),s=n.getExtension("WEBGL_debug_renderer_info"),r=s?String(n.getParameter(s.UNMASKED_RENDERER_WEBGL)):"";if(t||/swiftshader|llvmpipe|software|basic render/i.test(r))return{canvas:i,context:n,software:!t};let o=i.
cloneNode();return i.replaceWith(o),n.getExtension("WEBGL_lose_context")?.loseContext(),{canvas:o,context:e(o,!0),software:!1}}function Gf(i,t){return new de().compose(new H(...i),new ui(t[1],t[2],t[3],t[0]),new H(1,1,1))}function $S(i){let t=i.radius??1,[e,n,s]=i.kind==="sphere"?[t,t,t]:i.kind==="box"||i.kind==="ellipsoid"?i.halfExtents??[1,1,1]:i.kind==="cylinder"||i.kind==="cone"?[t,t,i.halfLength??
1]:i.kind==="circle"?[t,t,.08*t]:[1,1,1];return Gf(i.position,i.orientation).scale(new H(e,n,s))}var Og=new H,Hf=new ui,ZS=new H(1,1,1),JS=new H(0,0,0);function KS(i,t,e){Og.set(t[e],t[e+1],t[e+2]),Hf.set(t[e+4],t[e+5],t[e+6],t[e+3]),i.compose(Og,Hf,Hf.lengthSq()>0?ZS:JS)}var jS=400,Ao=class{constructor(t,e,n,s,r=null){this.box=t;this.model=e;this.handler=n;this.lead=r;this.camera=new bl;this.space=null;this.show={contacts:!0,trails:!1};this.forceFactor=1;this.selected=-1;this.followed=-1;this.hand=null;this.touched=!1;this.besides=[];this.t=0;this.anchor=[0,0,0];this.ratio=0;let o=a=>t.querySelector(`canvas.${a}`);if(this.flat=new Ml(o("flat"),e),this.overlay=new Sl(
o("overlay"),e.film),s!=="0")try{this.space=new Mh(o("space"),e,s==="fine")}catch{console.info("no WebGL: plain canvas")}this.camera.perspective=this.space!==null,this.camera.upAxis=e.upAxis,e.upAxis===1&&(this.camera.azimuth=28*Math.PI/180),this.size=e.extent.size,this.addPointer(this.overlay.canvas)}get spatial(){return this.camera.isPlanar&&this.model.bodies.length<=jS?null:this.space}draw(t){if(this.
t=t,this.followed>=0&&!this.model.film.absent(this.followed,t)){let{r:n}=this.model.film.pose(this.followed,t);this.camera.centre=_t(this.camera.centre,Zt(n,this.anchor)),this.anchor=n}let e=this.spatial;this.flat.canvas.hidden=e!==null,this.space&&(this.space.canvas.hidden=e===null),(e??this.flat).draw(this.camera,t,this.selected),this.overlay.hand=this.hand?.line??null,this.overlay.draw(this.camera,
t,this.lead?.size??this.size,this.show,this.forceFactor)}setView(t){this.camera.view=t,this.camera.look(),this.fit()}fit(){let t=this.followed>=0?this.model.pointsAround(this.followed,this.anchor):[...this.model.extent.points,...this.besides];this.size=this.followed>=0?Sp(t):this.model.extent.size,this.camera.fit(t)}follow(t,e){this.followed=t,t>=0&&(this.anchor=this.model.film.pose(t,e).r)}hide(t){
this.flat.hidden=t,this.space?.hide(t)}unitsPerCm(t){let e=this.overlay.perUnit(this.size,this.forceFactor,t)*this.camera.scale;return e>0?96/2.54/e:0}recolour(){this.flat.recolour(),this.space?.recolour()}resize(){let t=Math.min(window.devicePixelRatio||1,2),{clientWidth:e,clientHeight:n}=this.box;if(!e||!n||e===this.camera.width&&n===this.camera.height&&t===this.ratio)return!1;this.ratio=t;let s=this.
camera.width<=1;for(let o of[this.flat,this.space,this.overlay])o?.resize(e,n,t);let r=Math.min(e/this.camera.width,n/this.camera.height);return this.camera.width=e,this.camera.height=n,s||(this.camera.scale*=r),!0}picture(t){this.draw(t);let e=document.createElement("canvas"),n=this.spatial?this.spatial.canvas:this.flat.canvas;e.width=n.width,e.height=n.height;let s=e.getContext("2d");return s.drawImage(
n,0,0),s.drawImage(this.overlay.canvas,0,0,e.width,e.height),e}addPointer(t){let e=new Map,{camera:n}=this.lead??this,s=0,r=null;t.addEventListener("pointerdown",a=>{t.setPointerCapture(a.pointerId),t.classList.add("dragged"),e.set(a.pointerId,[a.offsetX,a.offsetY]),e.size===1&&(s=0);let l=this.hand?.goes&&!this.overlay.measure?.on&&e.size===1&&!a.shiftKey&&a.button===0?this.hitAt(a.offsetX,a.offsetY):
null;r=l?.point??null,l&&this.hand?.grab(l)}),t.addEventListener("pointermove",a=>{let l=e.get(a.pointerId);if(!l)return;let[c,u]=[a.offsetX-l[0],a.offsetY-l[1]],h=[...e].filter(([f])=>f!==a.pointerId).map(([,f])=>f);if(e.set(a.pointerId,[a.offsetX,a.offsetY]),s+=Math.abs(c)+Math.abs(u),r){this.hand?.move(this.hand.pointAt(a.offsetX,a.offsetY,r)),this.handler.redraw();return}if((this.lead??this).touched=
!0,h.length){let f=(d,g)=>Math.hypot(d-h[0][0],g-h[0][1])||1;n.zoom(f(a.offsetX,a.offsetY)/f(l[0],l[1]),h[0][0],h[0][1]),n.pan(c/2,u/2)}else n.isPlanar||a.shiftKey||a.buttons>1?n.pan(c,u):n.orbit(c,u);this.handler.redraw()});let o=a=>{let l=e.size===1;if(e.delete(a.pointerId),t.classList.remove("dragged"),r&&(r=null,this.hand?.release(),this.handler.redraw()),a.type!=="pointerup"||!l||s>5||this.handler.
clicked(a.offsetX,a.offsetY))return;let c=this.spatial,u=c?c.pick(this.camera,a.offsetX,a.offsetY):this.pickFlat(a.offsetX,a.offsetY);this.handler.selected(u)};t.addEventListener("pointerup",o),t.addEventListener("pointercancel",o),t.addEventListener("contextmenu",a=>a.preventDefault()),t.addEventListener("wheel",a=>{a.preventDefault(),(this.lead??this).touched=!0,n.zoom(Math.exp(-.0012*a.deltaY),
a.offsetX,a.offsetY),this.handler.redraw()},{passive:!1})}hitAt(t,e){let{camera:n}=this,s=this.spatial;if(s){let c=s.hit(n,t,e);return c.frame>=0?c:null}let r=this.pickFlat(t,e);if(r<0)return null;let{r:o}=this.model.film.pose(r,this.t),a=n.scaleAt(o)||n.scale,l=It(Zt(o,n.centre),n.toward);return{frame:r,point:_t(n.centre,_t(yt(n.toward,l),_t(yt(n.right,(t-n.width/2)/a),yt(n.up,(n.height/2-e)/a))))}}pickFlat(t,e){
return this.flat.pick(t,e)}};var Sh=class{constructor(t,e,n,s,r,o){this.other=e;this.first=n;this.scene=s;this.hidden=new Set;let a=["space","flat","overlay"].map(l=>St("canvas","",l));a[2].setAttribute("aria-label","motion of the other run"),t.replaceChildren(...a),this.stage=new Ao(t,new Cs(e.scene,e.film),{...r,selected:l=>r.selected(this.frameOf(l))},o,n),this.stage.overlay.axes=!1}frameOf(t){let e=this.other.scene.frames[t]?.
name;return e===void 0?-1:this.scene.frames.findIndex(n=>n.name===e)}twin(t){return this.other.frameNamed(this.scene.frames[t]?.name)}draw(t){this.adopt(t),this.stage.draw(t)}picture(t){return this.adopt(t),this.stage.picture(t)}adopt(t){let{first:e,stage:n}=this,{width:s,height:r,perspective:o}=n.camera;Object.assign(n.camera,e.camera,{width:s,height:r,perspective:o});let a=this.twin(e.followed);
if(a>=0){let l=this.other.film.pose(a,t).r,c=e.model.film.pose(e.followed,t).r;n.camera.centre=_t(e.camera.centre,Zt(l,c))}Object.assign(n,{show:e.show,forceFactor:e.forceFactor,selected:this.twin(e.selected)}),n.overlay.usualForce=e.overlay.usualForce||this.own(l=>l.usualForce()),n.overlay.usualImpact=e.overlay.usualImpact||this.own(l=>l.usualImpact()),n.overlay.labels=e.overlay.labels.map(({frame:l,
text:c})=>({frame:this.twin(l),text:c})).filter(l=>l.frame>=0),e.flat.hidden!==this.hidden&&(this.hidden=e.flat.hidden,n.hide(new Set([...this.hidden].map(l=>this.twin(l)).filter(l=>l>=0))))}own(t){return t(this.other.film)}close(){this.stage.space?.dispose()}};var Bg=8;function kg(i,t,e,n){if(!(i instanceof HTMLCanvasElement))return;let s=window.devicePixelRatio||1,{clientWidth:r,clientHeight:o}=i;i.width=r*s,i.height=o*s;let a=i.getContext("2d");if(!a||!r||!(n>e))return;a.scale(s,s);let l=t.some(u=>u.other),c=l?3:6;for(let u of[!1,!0]){a.fillStyle=(u?En[3]:En[2]).colour+(jt.dark?"b0":"90");let h=[new Set,new Set];for(let f of t){if(f.impact!==u||f.brief)
continue;let d=Math.round(Bg+(r-2*Bg)*(f.t-e)/(n-e)),g=l&&f.other===!0,v=h[g?1:0];if(v.has(d))continue;v.add(d);let m=l&&!g?c:0;a.fillRect(d,u?m:25-c-m,1.4,c)}}}var Co=i=>document.getElementById(i),wh=class{constructor(t,e,n,s){this.replay=t;this.handler=e;this.webgl=n;this.apart=s;this.other=null;this.beside=null;this.box=Co("beside");this.captions=["stage","beside"].map(()=>St("p","","caption"));Co("stages").append(...this.captions)}get isBeside(){return this.beside!==null}get stacked(){return this.isBeside&&this.box.offsetTop>Co("stage").offsetTop}show(t){
this.other=t,this.apply()}setApart(t){this.apart=t,this.apply()}get names(){return this.captions.filter(t=>!t.hidden).map(t=>t.textContent??"")}events(t){let{other:e}=this;if(!e)return t;let n=(s,r,o)=>s.map(a=>({...a,run:r,other:o}));return[...n(t,this.replay.data.title,!1),...n(e.events,e.title,!0)].sort((s,r)=>s.t-r.t)}ledger(t){let e=cl(t);return this.other?this.other.addLedger(e,this.replay.data.
title):e}paintMarks(t){kg(Co("marks"),this.events(t),this.replay.begin,this.replay.end)}showHead(){let{data:t,begin:e,end:n,film:s}=this.replay;mp(Co("facts"),t,this.other?Ss(s,[])[1]-e:n-e,s.count,this.other)}apply(){let{stage:t,scene:e}=this.replay,{other:n}=this,s=n!==null&&this.apart;this.beside?.close(),this.beside=null,this.box.hidden=!s,Co("stages").classList.toggle("two",s),s&&(this.beside=
new Sh(this.box,n,t,e,this.handler,this.webgl)),t.overlay.other=s?null:n,t.besides=n?n.points:[];let r=this.replay.data.title,o=n?.leftOut??0,a=o>0&&n?`dashed: ${n.title}, without ${o} of its bodies`:`dashed: ${n?.title??""}`;this.captions.forEach((l,c)=>{l.hidden=!n||c===1&&!s,l.textContent=s?c===0?r:n.title:a}),this.resize(),t.touched||t.fit()}draw(t){this.beside?.draw(t)}resize(){let t=this.replay.
stage.resize();return this.beside?.stage.resize()||t}picture(t){let e=this.replay.stage.picture(t);if(!this.beside)return e;let n=this.beside.picture(t),s=St("canvas"),{stacked:r}=this;s.width=r?Math.max(e.width,n.width):e.width+n.width,s.height=r?e.height+n.height:Math.max(e.height,n.height);let o=s.getContext("2d"),a=r?[0,e.height]:[e.width,0];return o.drawImage(e,0,0),o.drawImage(n,...a),o.fillStyle=
"#888888",o.fillRect(Math.max(0,a[0]-1),Math.max(0,a[1]-1),r?s.width:2,r?2:s.height),s}};var Wf=class{constructor(){this.data=new Uint8Array(65536);this.length=0}room(t){if(this.length+t<=this.data.length)return;let e=new Uint8Array(Math.max(2*this.data.length,this.length+t));e.set(this.data),this.data=e}add(...t){this.put(t)}put(t){this.room(t.length),this.data.set(t,this.length),this.length+=t.length}word(t){this.add(t&255,t>>8&255)}text(t){this.put([...t].map(e=>e.charCodeAt(0)))}done(){
return this.data.slice(0,this.length)}},zg=(i,t,e)=>i>>3<<10|t>>3<<5|e>>3,Eh=class{constructor(){this.count=new Float64Array(32768);this.sum=[0,1,2].map(()=>new Float64Array(32768));this.colours=[];this.nearest=new Int16Array(32768).fill(-1)}look(t){for(let e=0;e<t.length;e+=4){let n=zg(t[e],t[e+1],t[e+2]);++this.count[n];for(let s=0;s<3;++s)this.sum[s][n]+=t[e+s]}}close(){let t=[];for(let a=0;a<32768;++a)
this.count[a]&&t.push(a);let e=(a,l)=>this.sum[l][a]/this.count[a],n=a=>Math.sqrt(this.count[a]),s=a=>{let l=0,c=0;for(let u=0;u<3;++u){let h=256,f=-1;for(let d of a)h=Math.min(h,e(d,u)),f=Math.max(f,e(d,u));f-h>l&&(l=f-h,c=u)}return[l,c]},r=a=>{let[l,c]=s(a);return{group:a,channel:c,size:l*Math.sqrt(a.reduce((u,h)=>u+n(h),0))}},o=[r(t)];for(;o.length<255;){let a=0;o.forEach((d,g)=>{d.size>o[a].size&&
(a=g)});let{group:l,channel:c,size:u}=o[a];if(!(u>0))break;l.sort((d,g)=>e(d,c)-e(g,c));let h=l.reduce((d,g)=>d+n(g),0)/2,f=1;for(let d=n(l[0]);f<l.length-1&&d<h;++f)d+=n(l[f]);o.splice(a,1,r(l.slice(0,f)),r(l.slice(f)))}for(let{group:a}of o){let l=a.reduce((c,u)=>c+this.count[u],0)||1;this.colours.push([0,1,2].map(c=>Math.round(a.reduce((u,h)=>u+this.sum[c][h],0)/l)))}}indexOf(t,e,n){let s=zg(t,e,
n);if(this.nearest[s]>=0)return this.nearest[s];let r=0,o=1/0;return this.colours.forEach(([a,l,c],u)=>{let h=2*(a-t)**2+4*(l-e)**2+(c-n)**2;h<o&&(o=h,r=u)}),this.nearest[s]=r}};function QS(i,t){t.add(8);let s=[],r=0,o=0,a=9,l=258,c=new Map,u=()=>{s.length&&(t.add(s.length),t.put(s),s=[])},h=d=>{for(o|=d<<r,r+=a;r>=8;)s.push(o&255),o>>>=8,r-=8,s.length===255&&u()};h(256);let f=i[0];for(let d=1;d<i.
length;++d){let g=f<<8|i[d],v=c.get(g);if(v!==void 0){f=v;continue}h(f),l===4096?(h(256),c=new Map,l=258,a=9):(l===1<<a&&++a,c.set(g,l++)),f=i[d]}h(f),h(257),r&&s.push(o&255),u(),t.add(0)}var Th=class{constructor(t,e,n){this.width=t;this.height=e;this.table=n;this.out=new Wf;this.before=null;this.written=0;let{out:s}=this;s.text("GIF89a"),s.word(t),s.word(e),s.add(247,0,0);for(let r=0;r<256;++r)s.
put(n.colours[r]??[0,0,0]);s.add(33,255,11),s.text("NETSCAPE2.0"),s.add(3,1,0,0,0)}add(t,e){let{out:n,width:s,height:r,table:o,before:a}=this,l=new Uint8Array(s*r);for(let m=0;m<l.length;++m)l[m]=o.indexOf(t[4*m],t[4*m+1],t[4*m+2]);let c=0,u=0,h=s-1,f=r-1;if(a){c=s,u=r,h=f=-1;for(let m=0,p=0;m<r;++m)for(let b=0;b<s;++b,++p)l[p]!==a[p]&&(c=Math.min(c,b),h=Math.max(h,b),u=Math.min(u,m),f=m);h<0&&(c=
u=h=f=0)}let d=new Uint8Array((h-c+1)*(f-u+1));for(let m=u,p=0;m<=f;++m)for(let b=c;b<=h;++b,++p){let T=m*s+b;d[p]=a&&a[T]===l[T]?255:l[T]}let g=Math.round(100*e),v=Math.max(2,g-this.written);this.written+=v,n.add(33,249,4,a?5:4),n.word(v),n.add(255,0,44);for(let m of[c,u,h-c+1,f-u+1])n.word(m);n.add(0),QS(d,n),this.before=l}done(){return this.out.add(59),this.out.done()}};var Vg=i=>{let t=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),e=0;for(let n of i)t.set(n,e),e+=n.length;return t};function Pi(i,...t){let e=t.reduce((s,r)=>s+r.length,0),n=[];for(let s=24;s>=0;s-=8)i>>>s&&n.push(i>>>s&255);return n.push(1,0,0,Math.floor(e/2**32),e>>>24&255,e>>>16&255,e>>>8&255,e&255),Vg([n,...t])}var ni=(i,t)=>Pi(i,[t>>>24&255,t>>>16&255,t>>>8&255,t&255]),Ah=(i,t)=>Pi(i,[...t].map(
e=>e.charCodeAt(0)));function t1(i,t){let e=new Uint8Array(8);return new DataView(e.buffer).setFloat64(0,t),Pi(i,e)}function e1(i,t,e,n,s){let r=[],o=0,a=[],l=()=>{a.length&&r.push(Pi(524531317,ni(231,o),...a)),a=[]};for(let c of i){(c.key||c.time-o>3e4)&&(l(),o=c.time);let u=c.time-o;a.push(Pi(163,[129,u>>8&255,u&255,c.key?128:0],c.data))}return l(),Vg([Pi(440786851,ni(17030,1),ni(17143,1),ni(17138,
4),ni(17139,8),Ah(17026,"webm"),ni(17031,4),ni(17029,2)),Pi(408125543,Pi(357149030,ni(2807729,1e6),Ah(19840,"dynamY"),Ah(22337,"dynamY"),t1(17545,s)),Pi(374648427,Pi(174,ni(215,1),ni(29637,1),ni(131,1),Ah(134,t),Pi(224,ni(176,e),ni(186,n)))),...r)])}var Xf=()=>typeof VideoEncoder<"u";async function Hg(i,t,e,n,s){let r=[],o=null,a=new VideoEncoder({output:u=>{let h=new Uint8Array(u.byteLength);u.copyTo(
h),r.push({time:Math.round(u.timestamp/1e3),key:u.type==="key",data:h})},error:u=>{o=u}}),l="V_VP9",c={codec:"vp09.00.41.08",width:e,height:n,framerate:t,latencyMode:"quality",bitrate:Math.max(4e5,.12*e*n*t)};(await VideoEncoder.isConfigSupported(c)).supported||(c.codec="vp8",l="V_VP8"),a.configure(c);for(let u=0;u<i;++u){let h=new VideoFrame(await s(u),{timestamp:Math.round(1e6*u/t),duration:Math.
round(1e6/t)});for(a.encode(h,{keyFrame:u%Math.max(1,Math.round(2*t))===0}),h.close();a.encodeQueueSize>8;)await new Promise(f=>setTimeout(f,5));if(o)throw o}return await a.flush(),a.close(),e1(r,l,e,n,1e3*i/t)}var n1="system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",Ch=class{constructor(t,e){this.replay=t;this.choice=e;this.count=Math.max(1,Math.round((e.to-e.from)*e.slower*e.fps));let{width:n,height:s}=t.comparison.picture(e.from),r=o=>Math.max(2,2*Math.round(o/2));this.picture=document.createElement("canvas"),this.picture.width=r(e.width??n),this.picture.height=r(e.height??s),this.ctx=this.
picture.getContext("2d",{willReadFrequently:!0})}paint(t){let{ctx:e,picture:n,choice:s,replay:r}=this,{width:o,height:a}=n,l=Math.min(s.from+t/(s.slower*s.fps),r.end);e.fillStyle=jt.paper,e.fillRect(0,0,o,a);let c=r.comparison.picture(l),u=Math.min(o/c.width,a/c.height),[h,f]=[c.width*u,c.height*u];return e.drawImage(c,(o-h)/2,(a-f)/2,h,f),this.caption(l),n}caption(t){let{ctx:e,picture:n,replay:s}=this,
r=Math.max(11,Math.round(n.height/40)),o=s.end-s.begin,a=Math.max(0,Math.min(6,3-Math.floor(Math.log10(o||1))));e.font=`${r}px ${n1}`,e.textBaseline="top",e.textAlign="left",e.fillStyle=jt.soft,e.fillText(`${t.toFixed(a)} s`,r,r);let{names:l,stacked:c}=s.comparison;if(l.forEach((h,f)=>{let d=(f+1)/l.length;e.fillText(h,r+(c?0:f*n.width/l.length),(c?d:1)*n.height-2*r)}),!s.stage.show.contacts||!s.film.
contactCount)return;e.textAlign="right";let u=n.width-r;for(let h of En.slice(1,4).reverse())e.fillStyle=jt.soft,e.fillText(h.name,u,r),u-=e.measureText(h.name).width+.5*r,e.fillStyle=jt.dark?Ye(h.colour,.2):h.colour,e.fillRect(u-r,1.45*r,r,.22*r),u-=2*r}pixels(t){return this.paint(t),this.ctx.getImageData(0,0,this.picture.width,this.picture.height).data}async gif(t){let e=new Eh,n=Math.min(this.count,
12);for(let r=0;r<n;++r)e.look(this.pixels(Math.floor(r*this.count/n)));e.close();let s=new Th(this.picture.width,this.picture.height,e);for(let r=0;r<this.count;++r)s.add(this.pixels(r),(r+1)/this.choice.fps),await t((r+1)/this.count);return s.done()}async webm(t){return Hg(this.count,this.choice.fps,this.picture.width,this.picture.height,async e=>(await t((e+1)/this.count),this.paint(e)))}png(t){
return this.paint(t).toDataURL("image/png").split(",")[1]}},i1=async i=>{let t=await new Promise(e=>{let n=new FileReader;n.onload=()=>e(String(n.result)),n.readAsDataURL(new Blob([i]))});return t.slice(t.indexOf(",")+1)},Rh=class{constructor(t){this.replay=t;this.film=null;this.share=0}begin(t){let{stage:e,comparison:n}=this.replay;if(t.width&&t.height){let c=document.getElementById("stages");c.style.
cssText=`position:fixed;left:0;top:0;z-index:9;width:${t.width}px;height:${t.height}px;min-height:0;flex-direction:${t.height>t.width?"column":"row"}`,document.getElementById("beside").style.border="none",n.resize(),e.fit()}let{begin:s,end:r}=this.replay,o=Math.max(t.from??s,s),a=Math.min(t.to??r,r),l=t.slower??1/Number(document.getElementById("speed").value);return this.film=new Ch(this.replay,{...t,
from:o,to:a,slower:l}),this.film.count}take(t){return this.film?.png(t)??""}async file(t){if(!this.film)return"";if(t==="webm"&&!Xf())throw new Error("this browser codes no films: take a GIF");let e=async n=>{this.share=n,await new Promise(s=>setTimeout(s,0))};return i1(await this.film[t](e))}};async function Gg(i,t,e){let n=e.textContent,s=async a=>{e.textContent=`${Math.round(100*a)} %`,await new Promise(
l=>setTimeout(l,0))},r=new Ch(i,{from:i.begin,to:i.end,slower:1/t,fps:25}),o=Xf()?"webm":"gif";try{let a=await r[o](s),l=document.createElement("a");l.href=URL.createObjectURL(new Blob([a],{type:o==="webm"?"video/webm":"image/gif"})),l.download=`${i.data.title}.${o}`,l.click()}finally{e.textContent=n,i.draw()}}var s1="uplot",r1="u-hz",o1="u-vt",a1="u-title",l1="u-wrap",c1="u-under",h1="u-over",u1="u-axis",br="u-off",f1="u-select",d1="u-cursor-x",p1="u-cursor-y",m1="u-cursor-pt",g1="u-legend",v1="u-live",y1="u-inline",x1="u-series",_1="u-marker",Wg="u-label",b1="u-value",Ba="width",ka="height";var Xg="bottom",Ro="left",qf="right",cd="#000",qg=cd+"0",Yf="mousemove",Yg="mousedown",$f="mouseup",$g="mouseenter",Zg="mouseleave",Jg="dblclick",M1="resize",S1="scroll",Kg="change",Uh="dppxchange",hd="--",No=typeof window<"u",Qf=No?document:null,Io=No?window:null,w1=No?navigator:null,Ce,Ph;function td(){let i=devicePixelRatio;Ce!=i&&(Ce=i,Ph&&nd(Kg,Ph,td),Ph=matchMedia(`(min-resolution: ${Ce-.001}\
dppx) and (max-resolution: ${Ce+.001}dppx)`),Mr(Kg,Ph,td),Io.dispatchEvent(new CustomEvent(Uh)))}function ii(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function ed(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Je(i,t,e){i.style[t]=e+"px"}function Ii(i,t,e,n){let s=Qf.createElement(i);return t!=null&&ii(s,t),e?.insertBefore(s,n),s}function mi(i,t){return Ii("div",i,t)}
var jg=new WeakMap;function Yi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=jg.get(i);r!=o&&(i.style.transform=r,jg.set(i,r),t<0||e<0||t>n||e>s?ii(i,br):ed(i,br))}var Qg=new WeakMap;function t0(i,t,e){let n=t+e,s=Qg.get(i);n!=s&&(Qg.set(i,n),i.style.background=t,i.style.borderColor=e)}var e0=new WeakMap;function n0(i,t,e,n){let s=t+""+e,r=e0.get(i);s!=r&&(e0.set(i,s),i.style.height=e+"px",i.style.
width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var ud={passive:!0},E1={...ud,capture:!0};function Mr(i,t,e,n){t.addEventListener(i,e,n?E1:ud)}function nd(i,t,e,n){t.removeEventListener(i,e,ud)}No&&td();function Li(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:si((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function P0(i){return(e,n,s)=>{
let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var I0=i=>i!=null,L0=i=>i!=null&&i>0,Oh=P0(I0),T1=P0(L0);function A1(i,t,e,n=0,s=!1){let r=s?T1:Oh,o=s?L0:I0;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Oe,l??-Oe]}function Bh(i,t,e,n){
let s=r0(i),r=r0(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ps:D0,a=s==1?si:gi,l=r==1?gi:si,c=a(o(fn(i))),u=l(o(fn(t))),h=Lo(e,c),f=Lo(e,u);return e==10&&(c<0&&(h=Be(h,-c)),u<0&&(f=Be(f,-u))),n||e==2?(i=h*s,t=f*r):(i=O0(i,h),t=kh(t,f)),[i,t]}function fd(i,t,e,n){let s=Bh(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var dd=.1,i0={mode:3,pad:dd},Va={pad:0,soft:null,mode:0},C1={min:Va,max:Va};
function Fh(i,t,e,n){return zh(e)?s0(i,t,e):(Va.pad=e,Va.soft=n?0:null,Va.mode=n?3:0,s0(i,t,C1))}function we(i,t){return i??t}function R1(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function s0(i,t,e){let n=e.min,s=e.max,r=we(n.pad,0),o=we(s.pad,0),a=we(n.hard,-Oe),l=we(s.hard,Oe),c=we(n.soft,Oe),u=we(s.soft,-Oe),h=we(n.mode,0),f=we(s.mode,0),d=t-i,g=ps(d),v=Vn(
fn(i),fn(t)),m=ps(v),p=fn(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=Oe&&(r=0),f==2&&u!=-Oe&&(o=0)));let b=d||v||1e3,T=ps(b),_=Lo(10,si(T)),C=b*(d==0?i==0?.1:1:r),A=Be(O0(i-C,_/10),24),D=i>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Oe,F=Vn(a,A<D&&i>=D?D:Di(D,A)),w=b*(d==0?t==0?.1:1:o),S=Be(kh(t+w,_/10),24),R=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Oe,O=Di(l,S>R&&t<=R?R:Vn(R,S));return F==
O&&F==0&&(O=100),[F,O]}var P1=new Intl.NumberFormat(No?w1.language:"en-US"),pd=i=>P1.format(i),ri=Math,Dh=ri.PI,fn=ri.abs,si=ri.floor,un=ri.round,gi=ri.ceil,Di=ri.min,Vn=ri.max,Lo=ri.pow,r0=ri.sign,ps=ri.log10,D0=ri.log2,I1=(i,t=1)=>ri.sinh(i)*t,Zf=(i,t=1)=>ri.asinh(i/t),Oe=1/0;function o0(i){return(ps((i^i>>31)-(i>>31))|0)+1}function id(i,t,e){return Di(Vn(i,t),e)}function U0(i){return typeof i==
"function"}function ve(i){return U0(i)?i:()=>i}var L1=()=>{},F0=i=>i,N0=(i,t)=>t,D1=i=>null,a0=i=>!0,l0=(i,t)=>i==t,U1=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=i=>{if(k0(i)||Gs.has(i))return i;let t=`${i}`,e=t.match(U1);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Sr(s)}e${r}`}return Be(i,n)};function xr(i,t){return Sr(Be(Sr(i/t))*t)}function kh(i,t){return Sr(
gi(Sr(i/t))*t)}function O0(i,t){return Sr(si(Sr(i/t))*t)}function Be(i,t=0){if(k0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return un(n)/e}var Gs=new Map;function B0(i){return((""+i).split(".")[1]||"").length}function Ga(i,t,e,n){let s=[],r=n.map(B0);for(let o=t;o<e;o++){let a=fn(o),l=Be(Lo(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),
f=i==10?u:Be(u,h);s.push(f),Gs.set(f,h)}}return s}var Ha={},md=[],Do=[null,null],Hs=Array.isArray,k0=Number.isInteger,F1=i=>i===void 0;function c0(i){return typeof i=="string"}function zh(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function N1(i){return i!=null&&typeof i=="object"}var O1=Object.getPrototypeOf(Uint8Array),z0="__proto__";function Uo(i,t=zh){let e;if(Hs(
i)){let n=i.find(s=>s!=null);if(Hs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Uo(i[s],t)}else e=i.slice()}else if(i instanceof O1)e=i.slice();else if(t(i)){e={};for(let n in i)n!=z0&&(e[n]=Uo(i[n],t))}else e=i;return e}function an(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=z0&&(zh(i[s])?an(i[s],Uo(n[s])):i[s]=Uo(n[s]))}return i}var B1=0,k1=1,z1=2;function V1(i,t,e){
for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function H1(i,t){if(X1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return q1(o[0])||(o=W1(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],
s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:k1,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=B1&&(h[m]=v,f==z1&&d.push(m)):h[m]=v}V1(h,d,s),n.push(h)}}return n}var G1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function W1(i){
let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function X1(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function q1(i,t=100){let e=i.
length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Vn(1,si((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var V0=["January","February","March","April","May","June","July","August","September","October","November","December"],H0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Frid\
ay","Saturday"];function G0(i){return i.slice(0,3)}var Y1=H0.map(G0),$1=V0.map(G0),Z1={MMMM:V0,MMM:$1,WWWW:H0,WWW:Y1};function Oa(i){return(i<10?"0":"")+i}function J1(i){return(i<10?"00":i<100?"0":"")+i}var K1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Oa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Oa(i.getDate()),
D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Oa(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Oa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Oa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>J1(i.getMilliseconds())};function gd(i,t){
t=t||Z1;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?K1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var j1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Q1(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==j1?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),
e.setMilliseconds(i.getMilliseconds())),e}var W0=i=>i%1==0,Nh=[1,2,2.5,5],tw=Ga(10,-32,0,Nh),X0=Ga(10,0,32,Nh),ew=X0.filter(W0),_r=tw.concat(X0),vd=`
`,q0="{YYYY}",h0=vd+q0,Y0="{M}/{D}",za=vd+Y0,Ih=za+"/{YY}",$0="{aa}",nw="{h}:{mm}",Po=nw+$0,u0=vd+Po,f0=":{ss}",Re=null;function Z0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ga(10,0,3,Nh).filter(W0):Ga(10,-3,0,Nh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),
c=[[o,q0,Re,Re,Re,Re,Re,Re,1],[s*28,"{MMM}",h0,Re,Re,Re,Re,Re,1],[s,Y0,h0,Re,Re,Re,Re,Re,1],[n,"{h}"+$0,Ih,Re,za,Re,Re,Re,1],[e,Po,Ih,Re,za,Re,Re,Re,1],[t,f0,Ih+" "+Po,Re,za+" "+Po,Re,u0,Re,1],[i,f0+".{fff}",Ih+" "+Po,Re,za+" "+Po,Re,u0,Re,1]];function u(h){return(f,d,g,v,m,p)=>{let b=[],T=m>=o,_=m>=r&&m<o,C=h(g),A=Be(C*i,3),D=Jf(C.getFullYear(),T?0:C.getMonth(),_||T?1:C.getDate()),F=Be(D*i,3);if(_||
T){let w=_?m/r:0,S=T?m/o:0,R=A==F?A:Be(Jf(D.getFullYear()+S,D.getMonth()+w,1)*i,3),O=new Date(un(R/i)),z=O.getFullYear(),W=O.getMonth();for(let X=0;R<=v;X++){let q=Jf(z+S*X,W+w*X,1),Z=q-h(Be(q*i,3));R=Be((+q+Z)*i,3),R<=v&&b.push(R)}}else{let w=m>=s?s:m,S=si(g)-si(A),R=F+S+kh(A-F,w);b.push(R);let O=h(R),z=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,W=m/n,X=f.axes[d]._space,q=p/X;for(;R=Be(R+m,i==
1?0:3),!(R>v);)if(W>1){let Z=si(Be(z+W,6))%24,ot=h(R).getHours()-Z;ot>1&&(ot=-1),R-=ot*n,z=(z+W)%24;let vt=b[b.length-1];Be((R-vt)/m,3)*q>=.7&&b.push(R)}else b.push(R)}return b}}return[l,c,u]}var[iw,sw,rw]=Z0(1),[ow,aw,lw]=Z0(.001);Ga(2,-53,53,[1]);function d0(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function p0(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=
g[0])||t[t.length-1],l,c,u,h,f,d;return n.map(g=>{let v=i(g),m=v.getFullYear(),p=v.getMonth(),b=v.getDate(),T=v.getHours(),_=v.getMinutes(),C=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||b!=u&&a[4]||T!=h&&a[5]||_!=f&&a[6]||C!=d&&a[7]||a[1];return l=m,c=p,u=b,h=T,f=_,d=C,A(v)})}}function cw(i,t){let e=gd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Jf(i,t,e){return new Date(i,t,e)}function m0(i,t){
return t(i)}var hw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function g0(i,t){return(e,n,s,r)=>r==null?hd:t(i(n))}function uw(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function fw(i,t){return i.series[t].fill(i,t)}var dw={show:!0,live:!0,isolate:!1,mount:L1,markers:{show:!0,width:2,stroke:uw,fill:fw,dash:"solid"},idx:null,idxs:null,values:[]};function pw(i,t){
let e=i.cursor.points,n=mi(),s=e.size(i,t);Je(n,Ba,s),Je(n,ka,s);let r=s/-2;Je(n,"marginLeft",r),Je(n,"marginTop",r);let o=e.width(i,t,s);return o&&Je(n,"borderWidth",o),n}function mw(i,t){let e=i.series[t].points;return e._fill||e._stroke}function gw(i,t){let e=i.series[t].points;return e._stroke||e._fill}function vw(i,t){return i.series[t].points.size}var Kf=[0,0];function yw(i,t,e){return Kf[0]=
t,Kf[1]=e,Kf}function Lh(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function jf(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var xw={show:!0,x:!0,y:!0,lock:!1,move:yw,points:{one:!1,show:pw,size:vw,width:0,stroke:gw,fill:mw},bind:{mousedown:Lh,mouseup:Lh,click:Lh,dblclick:Lh,mousemove:jf,mouseleave:jf,mouseenter:jf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),
t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},J0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},yd=an({},J0,{filter:N0}),K0=an({},yd,{size:10}),j0=an({},J0,{show:!1}),xd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", s\
ans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Q0="bold "+xd,tv=1.5,v0={show:!0,scale:"x",stroke:cd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Q0,side:2,grid:yd,ticks:K0,border:j0,font:xd,lineGap:tv,rotate:0},_w="Value",bw="Time",y0={show:!0,scale:"x",auto:!1,sorted:1,min:Oe,max:-Oe,idxs:[]};function Mw(i,t,e,n,s){return t.map(r=>r==
null?"":pd(r))}function Sw(i,t,e,n,s,r,o){let a=[],l=Gs.get(s)||0;e=o?e:Be(kh(e,s),l);for(let c=e;c<=n;c=Be(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function sd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ps:D0,u=si(c(e));s=Lo(l,u),l==10&&(s=_r[Li(s,_r)]);let h=e,f=s*l;l==10&&(f=_r[Li(f,_r)]);do a.push(h),h=h+s,l==10&&!Gs.has(h)&&(h=Be(h,Gs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=
_r[Li(f,_r)]));while(h<=n);return a}function ww(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?sd(i,t,Vn(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?sd(i,t,Vn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}var ev=/./,Ew=/[12357]/,Tw=/[125]/,x0=/1/,rd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Aw(i,t,e,n,s){let r=i.axes[e],o=r.scale,
a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?ev:l(7,o)-u>=c?Ew:l(5,o)-u>=c?Tw:x0;if(h==x0){let f=fn(l(1,o)-u);if(f<c)return rd(t.slice().reverse(),a.distr,h,gi(c/f)).reverse()}return rd(t,a.distr,h,1)}function Cw(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=fn(l(1,o)-l(2,o));return c<a?rd(t.slice().reverse(),3,ev,gi(a/c)).reverse():t}function Rw(i,t,e,n){return n==
null?hd:t==null?"":pd(t)}var _0={show:!0,scale:"y",stroke:cd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Q0,side:3,grid:yd,ticks:K0,border:j0,font:xd,lineGap:tv,rotate:0};function Pw(i,t){let e=3+(i||1)*2;return Be(e*t,3)}function Iw(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=fn(o-r),l=i.series[t],c=a/(l.points.space*
Ce);return n[1]-n[0]<=c}var b0={scale:null,auto:!0,sorted:0,min:Oe,max:-Oe},nv=(i,t,e,n,s)=>s,M0={show:!0,auto:!0,sorted:0,gaps:nv,alpha:1,facets:[an({},b0,{scale:"x"}),an({},b0,{scale:"y"})]},S0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:nv,alpha:1,points:{show:Iw,filter:null},values:null,min:Oe,max:-Oe,idxs:[],path:null,clip:null};function Lw(i,t,e,n,s){return e/10}var iv={time:!0,auto:!0,
distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Dw=an({},iv,{time:!1,ori:1}),w0={};function sv(i,t){let e=w0[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(w0[i]=e)),e}var Fo=1,od=2;function wr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?
i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,Hh,Oo,Wh,ov,lv):e(s,l,c,u,h,p,m,d,f,v,g,Gh,Bo,Md,av,cv)}function _d(i,t){let e=0,n=0,s=we(i.bands,md);for(let r=0;r<s.length;r++){let o=s[r];o.
series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Uw(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ms(i,t,e,n,s,r){return wr(i,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound,b=c.dir*(c.ori==0?1:-1),T=c.ori==0?Oo:Bo,_,C;b==1?(_=e,C=n):(_=n,C=
e);let A=p(h(a[_],c,v,d)),D=p(f(l[_],u,m,g)),F=p(h(a[C],c,v,d)),w=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return T(S,F,w),T(S,A,w),T(S,A,D),S})}function Vh(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Wh:Md,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Fw(i,t,e){let n=i[i.
length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function bd(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[h]),g=f==h?d:r(i[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(i[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&a.push([d,g])}return a}function E0(i){return i==0?F0:i==1?un:t=>xr(
t,i)}function rv(i){let t=i==0?Hh:Gh,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Di(c,a/2,l/2),u=Di(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Hh=(i,t,e)=>{i.moveTo(t,
e)},Gh=(i,t,e)=>{i.moveTo(e,t)},Oo=(i,t,e)=>{i.lineTo(t,e)},Bo=(i,t,e)=>{i.lineTo(e,t)},Wh=rv(0),Md=rv(1),ov=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},av=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},lv=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},cv=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function hv(i){return(t,e,n,s,r)=>wr(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:b}=o,T,_;c.ori==0?(T=Hh,_=ov):
(T=Gh,_=av);let C=Be(b.width*Ce,3),A=(b.size-b.width)/2*Ce,D=Be(A*2,3),F=new Path2D,w=new Path2D,{left:S,top:R,width:O,height:z}=t.bbox;Wh(w,S-D,R-D,O+D*2,z+D*2);let W=X=>{if(l[X]!=null){let q=p(h(a[X],c,v,d)),Z=p(f(l[X],u,m,g));T(F,q+A,Z),_(F,q,Z,A,0,Dh*2)}};if(r)r.forEach(W);else for(let X=n;X<=s;X++)W(X);return{stroke:C>0?F:null,fill:F,clip:w,flags:Fo|od}})}function uv(i){return(t,e,n,s,r,o)=>{
n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Nw=uv(Oo),Ow=uv(Bo);function fv(i){let t=we(i?.alignGaps,0);return(e,n,s,r)=>wr(e,n,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=Oh(l,s,r);let p=o.pxRound,b=z=>p(h(z,c,v,d)),T=z=>p(f(z,u,m,g)),_,C;c.ori==0?(_=Oo,C=Nw):(_=Bo,C=Ow);let A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},F=D.stroke,w=!1;if(r-
s>=v*4){let z=pt=>e.posToVal(pt,c.key,!0),W=null,X=null,q,Z,j,rt=b(a[A==1?s:r]),ot=b(a[s]),vt=b(a[r]),bt=z(A==1?ot+1:vt-1);for(let pt=A==1?s:r;pt>=s&&pt<=r;pt+=A){let se=a[pt],Q=(A==1?se<bt:se>bt)?rt:b(se),tt=l[pt];Q==rt?tt!=null?(Z=tt,W==null?(_(F,Q,T(Z)),q=W=X=Z):Z<W?W=Z:Z>X&&(X=Z)):tt===null&&(w=!0):(W!=null&&C(F,rt,T(W),T(X),T(q),T(Z)),tt!=null?(Z=tt,_(F,Q,T(Z)),W=X=q=Z):(W=X=null,tt===null&&(w=
!0)),rt=Q,bt=z(rt+A))}W!=null&&W!=X&&j!=rt&&C(F,rt,T(W),T(X),T(q),T(Z))}else for(let z=A==1?s:r;z>=s&&z<=r;z+=A){let W=l[z];W===null?w=!0:W!=null&&_(F,b(a[z]),T(W))}let[R,O]=_d(e,n);if(o.fill!=null||R!=0){let z=D.fill=new Path2D(F),W=o.fillTo(e,n,o.min,o.max,R),X=T(W),q=b(a[s]),Z=b(a[r]);A==-1&&([Z,q]=[q,Z]),_(z,Z,X),_(z,q,X)}if(!o.spanGaps){let z=[];w&&z.push(...bd(a,l,s,r,A,b,t)),D.gaps=z=o.gaps(
e,n,s,r,z),D.clip=Vh(z,c.ori,d,g,v,m)}return O!=0&&(D.band=O==2?[ms(e,n,s,r,F,-1),ms(e,n,s,r,F,1)]:ms(e,n,s,r,F,O)),D})}function Bw(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),s=we(i.extend,!1);return(r,o,a,l)=>wr(r,o,(c,u,h,f,d,g,v,m,p,b,T)=>{[a,l]=Oh(h,a,l);let _=c.pxRound,{left:C,width:A}=r.bbox,D=ot=>_(g(ot,f,b,m)),F=ot=>_(v(ot,d,T,p)),w=f.ori==0?Oo:Bo,S={stroke:new Path2D,fill:null,
clip:null,band:null,gaps:null,flags:Fo},R=S.stroke,O=f.dir*(f.ori==0?1:-1),z=F(h[O==1?a:l]),W=D(u[O==1?a:l]),X=W,q=W;s&&t==-1&&(q=C,w(R,q,z)),w(R,W,z);for(let ot=O==1?a:l;ot>=a&&ot<=l;ot+=O){let vt=h[ot];if(vt==null)continue;let bt=D(u[ot]),pt=F(vt);t==1?w(R,bt,z):w(R,X,pt),w(R,bt,pt),z=pt,X=bt}let Z=X;s&&t==1&&(Z=C+A,w(R,Z,z));let[j,rt]=_d(r,o);if(c.fill!=null||j!=0){let ot=S.fill=new Path2D(R),vt=c.
fillTo(r,o,c.min,c.max,j),bt=F(vt);w(ot,Z,bt),w(ot,q,bt)}if(!c.spanGaps){let ot=[];ot.push(...bd(u,h,a,l,O,D,n));let vt=c.width*Ce/2,bt=e||t==1?vt:-vt,pt=e||t==-1?-vt:vt;ot.forEach(se=>{se[0]+=bt,se[1]+=pt}),S.gaps=ot=c.gaps(r,o,a,l,ot),S.clip=Vh(ot,f.ori,m,p,b,T)}return rt!=0&&(S.band=rt==2?[ms(r,o,a,l,R,-1),ms(r,o,a,l,R,1)]:ms(r,o,a,l,R,rt)),S})}function T0(i,t,e,n,s,r,o=Oe){if(i.length>1){let a=null;
for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=fn(i[l]-i[a]);u<c&&(c=u,o=fn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function kw(i){i=i||Ha;let t=we(i.size,[.6,Oe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ve(s),o=1-t[0],a=we(t[1],Oe),l=we(t[2],1),c=we(i.disp,Ha),u=we(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>wr(d,g,(p,b,T,_,C,A,D,F,w,S,R)=>{
let O=p.pxRound,z=e,W=n*Ce,X=a*Ce,q=l*Ce,Z,j;_.ori==0?[Z,j]=r(d,g):[j,Z]=r(d,g);let rt=_.dir*(_.ori==0?1:-1),ot=_.ori==0?Wh:Md,vt=_.ori==0?u:(N,J,nt,et,Bt,ht,Ut)=>{u(N,J,nt,Bt,et,Ut,ht)},bt=we(d.bands,md).find(N=>N.series[0]==g),pt=bt!=null?bt.dir:0,se=p.fillTo(d,g,p.min,p.max,pt),Kt=O(D(se,C,R,w)),Q,tt,wt,zt=S,xt=O(p.width*Ce),ne=!1,Pe=null,U=null,xe=null,te=null;h!=null&&(xt==0||f!=null)&&(ne=!0,
Pe=h.values(d,g,v,m),U=new Map,new Set(Pe).forEach(N=>{N!=null&&U.set(N,new Path2D)}),xt>0&&(xe=f.values(d,g,v,m),te=new Map,new Set(xe).forEach(N=>{N!=null&&te.set(N,new Path2D)})));let{x0:Yt,size:Ot}=c;if(Yt!=null&&Ot!=null){z=1,b=Yt.values(d,g,v,m),Yt.unit==2&&(b=b.map(nt=>d.posToVal(F+nt*S,_.key,!0)));let N=Ot.values(d,g,v,m);Ot.unit==2?tt=N[0]*S:tt=A(N[0],_,S,F)-A(0,_,S,F),zt=T0(b,T,A,_,S,F,zt),
wt=zt-tt+W}else zt=T0(b,T,A,_,S,F,zt),wt=zt*o+W,tt=zt-wt;wt<1&&(wt=0),xt>=tt/2&&(xt=0),wt<5&&(O=F0);let Ie=wt>0,Lt=zt-wt-(Ie?xt:0);tt=O(id(Lt,q,X)),Q=(z==0?tt/2:z==rt?0:tt)-z*rt*((z==0?W/2:0)+(Ie?xt/2:0));let qt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ge=ne?null:new Path2D,Ee=null;if(bt!=null)Ee=d.data[bt.series[1]];else{let{y0:N,y1:J}=c;N!=null&&J!=null&&(T=J.values(d,g,v,m),
Ee=N.values(d,g,v,m))}let I=Z*tt,x=j*tt;for(let N=rt==1?v:m;N>=v&&N<=m;N+=rt){let J=T[N];if(J==null)continue;if(Ee!=null){let gt=Ee[N]??0;if(J-gt==0)continue;Kt=D(gt,C,R,w)}let nt=_.distr!=2||c!=null?b[N]:N,et=A(nt,_,S,F),Bt=D(we(J,se),C,R,w),ht=O(et-Q),Ut=O(Vn(Bt,Kt)),Rt=O(Di(Bt,Kt)),at=Ut-Rt;if(J!=null){let gt=J<0?x:I,Gt=J<0?I:x;ne?(xt>0&&xe[N]!=null&&ot(te.get(xe[N]),ht,Rt+si(xt/2),tt,Vn(0,at-xt),
gt,Gt),Pe[N]!=null&&ot(U.get(Pe[N]),ht,Rt+si(xt/2),tt,Vn(0,at-xt),gt,Gt)):ot(Ge,ht,Rt+si(xt/2),tt,Vn(0,at-xt),gt,Gt),vt(d,g,N,ht-xt/2,Rt,tt+xt,at)}}return xt>0?qt.stroke=ne?te:Ge:ne||(qt._fill=p.width==0?p._fill:p._stroke??p._fill,qt.width=0),qt.fill=ne?U:Ge,qt})}function zw(i,t){let e=we(t?.alignGaps,0);return(n,s,r,o)=>wr(n,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=Oh(c,r,o);let b=a.pxRound,T=Z=>b(f(Z,u,
m,g)),_=Z=>b(d(Z,h,p,v)),C,A,D;u.ori==0?(C=Hh,D=Oo,A=lv):(C=Gh,D=Bo,A=cv);let F=u.dir*(u.ori==0?1:-1),w=T(l[F==1?r:o]),S=w,R=[],O=[];for(let Z=F==1?r:o;Z>=r&&Z<=o;Z+=F)if(c[Z]!=null){let rt=l[Z],ot=T(rt);R.push(S=ot),O.push(_(c[Z]))}let z={stroke:i(R,O,C,D,A,b),fill:null,clip:null,band:null,gaps:null,flags:Fo},W=z.stroke,[X,q]=_d(n,s);if(a.fill!=null||X!=0){let Z=z.fill=new Path2D(W),j=a.fillTo(n,
s,a.min,a.max,X),rt=_(j);D(Z,S,rt),D(Z,w,rt)}if(!a.spanGaps){let Z=[];Z.push(...bd(l,c,r,o,F,T,e)),z.gaps=Z=a.gaps(n,s,r,o,Z),z.clip=Vh(Z,u.ori,g,v,m,p)}return q!=0&&(z.band=q==2?[ms(n,s,r,o,W,-1),ms(n,s,r,o,W,1)]:ms(n,s,r,o,W,q)),z})}function Vw(i){return zw(Hw,i)}function Hw(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),
c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}
return a}var ad=new Set;function A0(){for(let i of ad)i.syncRect(!0)}No&&(Mr(M1,Io,A0),Mr(S1,Io,A0,!0),Mr(Uh,Io,()=>{bn.pxRatio=Ce}));var Gw=fv(),Ww=hv();function C0(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ld(r,o,t,e))}function Xw(i,t){return i.map((e,n)=>n==0?{}:an({},t,e))}function ld(i,t,e,n){return an({},t==0?e:n,i)}function dv(i,t,e){return t==null?
Do:[t,e]}var qw=dv;function Yw(i,t,e){return t==null?Do:Fh(t,e,dd,!0)}function pv(i,t,e,n){return t==null?Do:Bh(t,e,i.scales[n].log,!1)}var $w=pv;function mv(i,t,e,n){return t==null?Do:fd(t,e,i.scales[n].log,!1)}var Zw=mv;function Jw(i,t,e,n,s){let r=Vn(o0(i),o0(t)),o=t-i,a=Li(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Gs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function R0(i){
let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=un((e=+s)*Ce))+"px"),[i,t,e]}function Kw(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Be(t[2]*Ce,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function bn(i,t,e){let n={mode:we(i.mode,1)},s=n.mode;function r(y,M,P,L){let k=M.valToPct(y);return L+P*(M.dir==-1?1-k:k)}function o(y,M,P,L){let k=M.valToPct(y);return L+P*(M.dir==-1?k:1-k)}function a(y,M,P,L){
return M.ori==0?r(y,M,P,L):o(y,M,P,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=mi(s1);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let y=mi(a1,c);y.textContent=i.title}let u=Ii("canvas"),h=n.ctx=u.getContext("2d"),f=mi(l1,c);Mr("click",f,y=>{y.target===g&&(We!=Rr||Ke!=Pr)&&Sn.click(n,y)},!0);let d=n.under=mi(c1,f);f.appendChild(u);let g=n.over=mi(h1,f);i=Uo(i);let v=+we(i.
pxAlign,1),m=E0(v);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let p=i.ms||.001,b=n.series=s==1?C0(i.series||[],y0,S0,!1):Xw(i.series||[null],M0),T=n.axes=C0(i.axes||[],v0,_0,!0),_=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=ve(y.fill||null),y.dir=we(y.dir,-1)});let A=s==2?b[1].facets[0].scale:b[0].scale,D={axes:Ev,series:qs},F=(i.drawOrder||["axes","series"]).map(y=>D[y]);
function w(y){let M=y.distr==3?P=>ps(P>0?P:y.clamp(n,P,y.min,y.max,y.key)):y.distr==4?P=>Zf(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let L=M(P),{_min:k,_max:Y}=y,it=Y-k;return(L-k)/it}}function S(y){let M=_[y];if(M==null){let P=(i.scales||Ha)[y]||Ha;if(P.from!=null){S(P.from);let L=an({},_[P.from],P,{key:y});L.valToPct=w(L),_[y]=L}else{M=_[y]=an({},y==A?iv:Dw,P),M.key=y;let L=M.time,k=M.
range,Y=Hs(k);if((y!=A||s==2&&!L)&&(Y&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?i0:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?i0:{mode:1,hard:k[1],soft:k[1]}},Y=!1),!Y&&zh(k))){let it=k;k=(lt,mt,Ct)=>mt==null?Do:Fh(mt,Ct,it)}M.range=ve(k||(L?qw:y==A?M.distr==3?$w:M.distr==4?Zw:dv:M.distr==3?pv:M.distr==4?mv:Yw)),M.auto=ve(Y?!1:M.auto),M.clamp=ve(M.clamp||Lw),M._min=M._max=null,M.valToPct=w(M)}}}
S("x"),S("y"),s==1&&b.forEach(y=>{S(y.scale)}),T.forEach(y=>{S(y.scale)});for(let y in i.scales)S(y);let R=_[A],O=R.distr,z,W;R.ori==0?(ii(c,r1),z=r,W=o):(ii(c,o1),z=o,W=r);let X={};for(let y in _){let M=_[y];(M.min!=null||M.max!=null)&&(X[y]={min:M.min,max:M.max},M.min=M.max=null)}let q=i.tzDate||(y=>new Date(un(y/p))),Z=i.fmtDate||gd,j=p==1?rw(q):lw(q),rt=p0(q,d0(p==1?sw:aw,Z)),ot=g0(q,m0(hw,Z)),
vt=[],bt=n.legend=an({},dw,i.legend),pt=n.cursor=an({},xw,{drag:{y:s==2}},i.cursor),se=bt.show,Kt=pt.show,Q=bt.markers;bt.idxs=vt,Q.width=ve(Q.width),Q.dash=ve(Q.dash),Q.stroke=ve(Q.stroke),Q.fill=ve(Q.fill);let tt,wt,zt,xt=[],ne=[],Pe,U=!1,xe={};if(bt.live){let y=b[1]?b[1].values:null;U=y!=null,Pe=U?y(n,1,0):{_:0};for(let M in Pe)xe[M]=hd}if(se)if(tt=Ii("table",g1,c),zt=Ii("tbody",null,tt),bt.mount(
n,tt),U){wt=Ii("thead",null,tt,zt);let y=Ii("tr",null,wt);Ii("th",null,y);for(var te in Pe)Ii("th",Wg,y).textContent=te}else ii(tt,y1),bt.live&&ii(tt,v1);let Yt={show:!0},Ot={show:!1};function Ie(y,M){if(M==0&&(U||!bt.live||s==2))return Do;let P=[],L=Ii("tr",x1,zt,zt.childNodes[M]);ii(L,y.class),y.show||ii(L,br);let k=Ii("th",null,L);if(Q.show){let lt=mi(_1,k);if(M>0){let mt=Q.width(n,M);mt&&(lt.style.
border=mt+"px "+Q.dash(n,M)+" "+Q.stroke(n,M)),lt.style.background=Q.fill(n,M)}}let Y=mi(Wg,k);y.label instanceof HTMLElement?Y.appendChild(y.label):Y.textContent=y.label,M>0&&(Q.show||(Y.style.color=y.width>0?Q.stroke(n,M):Q.fill(n,M)),qt("click",k,lt=>{if(pt._lock)return;Mn(lt);let mt=b.indexOf(y);if((lt.ctrlKey||lt.metaKey)!=bt.isolate){let Ct=b.some((Pt,Nt)=>Nt>0&&Nt!=mt&&Pt.show);b.forEach((Pt,Nt)=>{
Nt>0&&Ni(Nt,Ct?Nt==mt?Yt:Ot:Yt,!0,sn.setSeries)})}else Ni(mt,{show:!y.show},!0,sn.setSeries)},!1),Hn&&qt($g,k,lt=>{pt._lock||(Mn(lt),Ni(b.indexOf(y),Lr,!0,sn.setSeries))},!1));for(var it in Pe){let lt=Ii("td",b1,L);lt.textContent="--",P.push(lt)}return[L,P]}let Lt=new Map;function qt(y,M,P,L=!0){let k=Lt.get(M)||{},Y=pt.bind[y](n,M,P,L);Y&&(Mr(y,M,k[y]=Y),Lt.set(M,k))}function Ge(y,M,P){let L=Lt.get(
M)||{};for(let k in L)(y==null||k==y)&&(nd(k,M,L[k]),delete L[k]);y==null&&Lt.delete(M)}let Ee=0,I=0,x=0,N=0,J=0,nt=0,et=J,Bt=nt,ht=x,Ut=N,Rt=0,at=0,gt=0,Gt=0;n.bbox={};let Ht=!1,Mt=!1,ie=!1,B=!1,ut=!1,dt=!1;function Dt(y,M,P){(P||y!=n.width||M!=n.height)&&ct(y,M),Er(!1),ie=!0,Mt=!0,Tr()}function ct(y,M){n.width=Ee=x=y,n.height=I=N=M,J=nt=0,Ue(),be();let P=n.bbox;Rt=P.left=xr(J*Ce,.5),at=P.top=xr(
nt*Ce,.5),gt=P.width=xr(x*Ce,.5),Gt=P.height=xr(N*Ce,.5)}let st=3;function Vt(){let y=!1,M=0;for(;!y;){M++;let P=Sv(M),L=wv(M);y=M==st||P&&L,y||(ct(n.width,n.height),Mt=!0)}}function re({width:y,height:M}){Dt(y,M)}n.setSize=re;function Ue(){let y=!1,M=!1,P=!1,L=!1;T.forEach((k,Y)=>{if(k.show&&k._show){let{side:it,_size:lt}=k,mt=it%2,Ct=k.label!=null?k.labelSize:0,Pt=lt+Ct;Pt>0&&(mt?(x-=Pt,it==3?(J+=
Pt,L=!0):P=!0):(N-=Pt,it==0?(nt+=Pt,y=!0):M=!0))}}),Zi[0]=y,Zi[1]=P,Zi[2]=M,Zi[3]=L,x-=Fi[1]+Fi[3],J+=Fi[3],N-=Fi[2]+Fi[0],nt+=Fi[0]}function be(){let y=J+x,M=nt+N,P=J,L=nt;function k(Y,it){switch(Y){case 1:return y+=it,y-it;case 2:return M+=it,M-it;case 3:return P-=it,P+it;case 0:return L-=it,L+it}}T.forEach((Y,it)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=k(lt,Y._size),Y.label!=null&&(Y._lpos=k(
lt,Y.labelSize))}})}if(pt.dataIdx==null){let y=pt.hover,M=y.skip=new Set(y.skip??[]);M.add(void 0);let P=y.prox=ve(y.prox),L=y.bias??=0;pt.dataIdx=(k,Y,it,lt)=>{if(Y==0)return it;let mt=it,Ct=P(k,Y,it,lt)??Oe,Pt=Ct>=0&&Ct<Oe,Nt=R.ori==0?x:N,oe=pt.left,Te=t[0],Se=t[Y];if(M.has(Se[it])){mt=null;let fe=null,ee=null,Xt;if(L==0||L==-1)for(Xt=it;fe==null&&Xt-- >0;)M.has(Se[Xt])||(fe=Xt);if(L==0||L==1)for(Xt=
it;ee==null&&Xt++<Se.length;)M.has(Se[Xt])||(ee=Xt);if(fe!=null||ee!=null)if(Pt){let qe=fe==null?-1/0:z(Te[fe],R,Nt,0),en=ee==null?1/0:z(Te[ee],R,Nt,0),yn=oe-qe,Fe=en-oe;yn<=Fe?yn<=Ct&&(mt=fe):Fe<=Ct&&(mt=ee)}else mt=ee==null?fe:fe==null?ee:it-fe<=ee-it?fe:ee}else Pt&&fn(oe-z(Te[it],R,Nt,0))>Ct&&(mt=null);return mt}}let Mn=y=>{pt.event=y};pt.idxs=vt,pt._lock=!1;let Ne=pt.points;Ne.show=ve(Ne.show),
Ne.size=ve(Ne.size),Ne.stroke=ve(Ne.stroke),Ne.width=ve(Ne.width),Ne.fill=ve(Ne.fill);let Yn=n.focus=an({},i.focus||{alpha:.3},pt.focus),Hn=Yn.prox>=0,Ui=Hn&&Ne.one,Un=[],$i=[],vi=[];function ko(y,M){let P=Ne.show(n,M);if(P instanceof HTMLElement)return ii(P,m1),ii(P,y.class),Yi(P,-10,-10,x,N),g.insertBefore(P,Un[M]),P}function Ws(y,M){if(s==1||M>0){let P=s==1&&_[y.scale].time,L=y.value;y.value=P?
c0(L)?g0(q,m0(L,Z)):L||ot:L||Rw,y.label=y.label||(P?bw:_w)}if(Ui||M>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Gw||D1,y.fillTo=ve(y.fillTo||Uw),y.pxAlign=+we(y.pxAlign,v),y.pxRound=E0(y.pxAlign),y.stroke=ve(y.stroke||null),y.fill=ve(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=Pw(Vn(1,y.width),1),L=y.points=an({},{size:P,width:Vn(1,P*.2),stroke:y.stroke,space:P*2,paths:Ww,
_stroke:null,_fill:null},y.points);L.show=ve(L.show),L.filter=ve(L.filter),L.fill=ve(L.fill),L.stroke=ve(L.stroke),L.paths=ve(L.paths),L.pxAlign=y.pxAlign}if(se){let P=Ie(y,M);xt.splice(M,0,P[0]),ne.splice(M,0,P[1]),bt.values.push(null)}if(Kt){vt.splice(M,0,null);let P=null;Ui?M==0&&(P=ko(y,M)):M>0&&(P=ko(y,M)),Un.splice(M,0,P),$i.splice(M,0,0),vi.splice(M,0,0)}vn("addSeries",M)}function qa(y,M){M=
M??b.length,y=s==1?ld(y,M,y0,S0):ld(y,M,{},M0),b.splice(M,0,y),Ws(b[M],M)}n.addSeries=qa;function Ya(y){if(b.splice(y,1),se){bt.values.splice(y,1),ne.splice(y,1);let M=xt.splice(y,1)[0];Ge(null,M.firstChild),M.remove()}Kt&&(vt.splice(y,1),Un.splice(y,1)[0].remove(),$i.splice(y,1),vi.splice(y,1)),vn("delSeries",y)}n.delSeries=Ya;let Zi=[!1,!1,!1,!1];function Xh(y,M){if(y._show=y.show,y.show){let P=y.
side%2,L=_[y.scale];L==null&&(y.scale=P?b[1].scale:A,L=_[y.scale]);let k=L.time;y.size=ve(y.size),y.space=ve(y.space),y.rotate=ve(y.rotate),Hs(y.incrs)&&y.incrs.forEach(it=>{!Gs.has(it)&&Gs.set(it,B0(it))}),y.incrs=ve(y.incrs||(L.distr==2?ew:k?p==1?iw:ow:_r)),y.splits=ve(y.splits||(k&&L.distr==1?j:L.distr==3?sd:L.distr==4?ww:Sw)),y.stroke=ve(y.stroke),y.grid.stroke=ve(y.grid.stroke),y.ticks.stroke=
ve(y.ticks.stroke),y.border.stroke=ve(y.border.stroke);let Y=y.values;y.values=Hs(Y)&&!Hs(Y[0])?ve(Y):k?Hs(Y)?p0(q,d0(Y,Z)):c0(Y)?cw(q,Y):Y||rt:Y||Mw,y.filter=ve(y.filter||(L.distr>=3&&L.log==10?Aw:L.distr==3&&L.log==2?Cw:N0)),y.font=R0(y.font),y.labelFont=R0(y.labelFont),y._size=y.size(n,null,M,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Zi[M]=!0,y._el=mi(u1,f))}}
function Xs(y,M,P,L){let[k,Y,it,lt]=P,mt=M%2,Ct=0;return mt==0&&(lt||Y)&&(Ct=M==0&&!k||M==2&&!it?un(v0.size/3):0),mt==1&&(k||it)&&(Ct=M==1&&!Y||M==3&&!lt?un(_0.size/2):0),Ct}let $a=n.padding=(i.padding||[Xs,Xs,Xs,Xs]).map(y=>ve(we(y,Xs))),Fi=n._padding=$a.map((y,M)=>y(n,M,Zi,0)),ln,E=null,V=null,K=s==1?b[0].idxs:null,$=null,G=!1;function ft(y,M){if(t=y??[],n.data=n._data=t,s==2){ln=0;for(let P=1;P<
b.length;P++)ln+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),$=t[0],ln=$.length;let P=t;if(O==2){P=t.slice();let L=P[0]=Array(ln);for(let k=0;k<ln;k++)L[k]=k}n._data=t=P}if(Er(!0),vn("setData"),O==2&&(ie=!0),M!==!1){let P=R;P.auto(n,G)?Et():xs(A,P.min,P.max),B=B||pt.left>=0,dt=!0,Tr()}}n.setData=ft;function Et(){G=!0;let y,M;s==1&&(ln>0?(E=K[0]=0,V=K[1]=ln-1,y=t[0][E],M=t[0][V],O==2?(y=
E,M=V):y==M&&(O==3?[y,M]=Bh(y,y,R.log,!1):O==4?[y,M]=fd(y,y,R.log,!1):R.time?M=y+un(86400/p):[y,M]=Fh(y,M,dd,!0))):(E=K[0]=y=null,V=K[1]=M=null)),xs(A,y,M)}let Ft,At,Jt,Qt,Wt,he,Me,ke,Le,ae;function $t(y,M,P,L,k,Y){y??=qg,P??=md,L??="butt",k??=qg,Y??="round",y!=Ft&&(h.strokeStyle=Ft=y),k!=At&&(h.fillStyle=At=k),M!=Jt&&(h.lineWidth=Jt=M),Y!=Wt&&(h.lineJoin=Wt=Y),L!=he&&(h.lineCap=he=L),P!=Qt&&h.setLineDash(
Qt=P)}function ze(y,M,P,L){M!=At&&(h.fillStyle=At=M),y!=Me&&(h.font=Me=y),P!=ke&&(h.textAlign=ke=P),L!=Le&&(h.textBaseline=Le=L)}function me(y,M,P,L,k=0){if(L.length>0&&y.auto(n,G)&&(M==null||M.min==null)){let Y=we(E,0),it=we(V,L.length-1),lt=P.min==null?A1(L,Y,it,k,y.distr==3):[P.min,P.max];y.min=Di(y.min,P.min=lt[0]),y.max=Vn(y.max,P.max=lt[1])}}let Cn={min:null,max:null};function gs(){for(let L in _){
let k=_[L];X[L]==null&&(k.min==null||X[A]!=null&&k.auto(n,G))&&(X[L]=Cn)}for(let L in _){let k=_[L];X[L]==null&&k.from!=null&&X[k.from]!=null&&(X[L]=Cn)}X[A]!=null&&Er(!0);let y={};for(let L in X){let k=X[L];if(k!=null){let Y=y[L]=Uo(_[L],N1);if(k.min!=null)an(Y,k);else if(L!=A||s==2)if(ln==0&&Y.from==null){let it=Y.range(n,null,null,L);Y.min=it[0],Y.max=it[1]}else Y.min=Oe,Y.max=-Oe}}if(ln>0){b.forEach(
(L,k)=>{if(s==1){let Y=L.scale,it=X[Y];if(it==null)return;let lt=y[Y];if(k==0){let mt=lt.range(n,lt.min,lt.max,Y);lt.min=mt[0],lt.max=mt[1],E=Li(lt.min,t[0]),V=Li(lt.max,t[0]),V-E>1&&(t[0][E]<lt.min&&E++,t[0][V]>lt.max&&V--),L.min=$[E],L.max=$[V]}else L.show&&L.auto&&me(lt,it,L,t[k],L.sorted);L.idxs[0]=E,L.idxs[1]=V}else if(k>0&&L.show&&L.auto){let[Y,it]=L.facets,lt=Y.scale,mt=it.scale,[Ct,Pt]=t[k],
Nt=y[lt],oe=y[mt];Nt!=null&&me(Nt,X[lt],Y,Ct,Y.sorted),oe!=null&&me(oe,X[mt],it,Pt,it.sorted),L.min=it.min,L.max=it.max}});for(let L in y){let k=y[L],Y=X[L];if(k.from==null&&(Y==null||Y.min==null)){let it=k.range(n,k.min==Oe?null:k.min,k.max==-Oe?null:k.max,L);k.min=it[0],k.max=it[1]}}}for(let L in y){let k=y[L];if(k.from!=null){let Y=y[k.from];if(Y.min==null)k.min=k.max=null;else{let it=k.range(n,
Y.min,Y.max,L);k.min=it[0],k.max=it[1]}}}let M={},P=!1;for(let L in y){let k=y[L],Y=_[L];if(Y.min!=k.min||Y.max!=k.max){Y.min=k.min,Y.max=k.max;let it=Y.distr;Y._min=it==3?ps(Y.min):it==4?Zf(Y.min,Y.asinh):it==100?Y.fwd(Y.min):Y.min,Y._max=it==3?ps(Y.max):it==4?Zf(Y.max,Y.asinh):it==100?Y.fwd(Y.max):Y.max,M[L]=P=!0}}if(P){b.forEach((L,k)=>{s==2?k>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});
for(let L in M)ie=!0,vn("setScale",L);Kt&&pt.left>=0&&(B=dt=!0)}for(let L in X)X[L]=null}function Fn(y){let M=id(E-1,0,ln-1),P=id(V+1,0,ln-1);for(;y[M]==null&&M>0;)M--;for(;y[P]==null&&P<ln-1;)P++;return[M,P]}function qs(){if(ln>0){let y=b.some(M=>M._focus)&&ae!=Yn.alpha;y&&(h.globalAlpha=ae=Yn.alpha),b.forEach((M,P)=>{if(P>0&&M.show&&(Ve(P,!1),Ve(P,!0),M._paths==null)){let L=ae;ae!=M.alpha&&(h.globalAlpha=
ae=M.alpha);let k=s==2?[0,t[P][0].length-1]:Fn(t[P]);M._paths=M.paths(n,P,k[0],k[1]),ae!=L&&(h.globalAlpha=ae=L)}}),b.forEach((M,P)=>{if(P>0&&M.show){let L=ae;ae!=M.alpha&&(h.globalAlpha=ae=M.alpha),M._paths!=null&&Nn(P,!1);{let k=M._paths!=null?M._paths.gaps:null,Y=M.points.show(n,P,E,V,k),it=M.points.filter(n,P,Y,k);(Y||it)&&(M.points._paths=M.points.paths(n,P,E,V,it),Nn(P,!0))}ae!=L&&(h.globalAlpha=
ae=L),vn("drawSeries",P)}}),y&&(h.globalAlpha=ae=1)}}function Ve(y,M){let P=M?b[y].points:b[y];P._stroke=P.stroke(n,y),P._fill=P.fill(n,y)}function Nn(y,M){let P=M?b[y].points:b[y],{stroke:L,fill:k,clip:Y,flags:it,_stroke:lt=P._stroke,_fill:mt=P._fill,_width:Ct=P.width}=P._paths;Ct=Be(Ct*Ce,3);let Pt=null,Nt=Ct%2/2;M&&mt==null&&(mt=Ct>0?"#fff":lt);let oe=P.pxAlign==1&&Nt>0;if(oe&&h.translate(Nt,Nt),
!M){let Te=Rt-Ct/2,Se=at-Ct/2,fe=gt+Ct,ee=Gt+Ct;Pt=new Path2D,Pt.rect(Te,Se,fe,ee)}M?pn(lt,Ct,P.dash,P.cap,mt,L,k,it,Y):Gn(y,lt,Ct,P.dash,P.cap,mt,L,k,it,Pt,Y),oe&&h.translate(-Nt,-Nt)}function Gn(y,M,P,L,k,Y,it,lt,mt,Ct,Pt){let Nt=!1;mt!=0&&C.forEach((oe,Te)=>{if(oe.series[0]==y){let Se=b[oe.series[1]],fe=t[oe.series[1]],ee=(Se._paths||Ha).band;Hs(ee)&&(ee=oe.dir==1?ee[0]:ee[1]);let Xt,qe=null;Se.
show&&ee&&R1(fe,E,V)?(qe=oe.fill(n,Te)||Y,Xt=Se._paths.clip):ee=null,pn(M,P,L,k,qe,it,lt,mt,Ct,Pt,Xt,ee),Nt=!0}}),Nt||pn(M,P,L,k,Y,it,lt,mt,Ct,Pt)}let dn=Fo|od;function pn(y,M,P,L,k,Y,it,lt,mt,Ct,Pt,Nt){$t(y,M,P,L,k),(mt||Ct||Nt)&&(h.save(),mt&&h.clip(mt),Ct&&h.clip(Ct)),Nt?(lt&dn)==dn?(h.clip(Nt),Pt&&h.clip(Pt),oi(k,it),vs(y,Y,M)):lt&od?(oi(k,it),h.clip(Nt),vs(y,Y,M)):lt&Fo&&(h.save(),h.clip(Nt),
Pt&&h.clip(Pt),oi(k,it),h.restore(),vs(y,Y,M)):(oi(k,it),vs(y,Y,M)),(mt||Ct||Nt)&&h.restore()}function vs(y,M,P){P>0&&(M instanceof Map?M.forEach((L,k)=>{h.strokeStyle=Ft=k,h.stroke(L)}):M!=null&&y&&h.stroke(M))}function oi(y,M){M instanceof Map?M.forEach((P,L)=>{h.fillStyle=At=L,h.fill(P)}):M!=null&&y&&h.fill(M)}function Mv(y,M,P,L){let k=T[y],Y;if(L<=0)Y=[0,0];else{let it=k._space=k.space(n,y,M,
P,L),lt=k._incrs=k.incrs(n,y,M,P,L,it);Y=Jw(M,P,lt,L,it)}return k._found=Y}function qh(y,M,P,L,k,Y,it,lt,mt,Ct){let Pt=it%2/2;v==1&&h.translate(Pt,Pt),$t(lt,it,mt,Ct,lt),h.beginPath();let Nt,oe,Te,Se,fe=k+(L==0||L==3?-Y:Y);P==0?(oe=k,Se=fe):(Nt=k,Te=fe);for(let ee=0;ee<y.length;ee++)M[ee]!=null&&(P==0?Nt=Te=y[ee]:oe=Se=y[ee],h.moveTo(Nt,oe),h.lineTo(Te,Se));h.stroke(),v==1&&h.translate(-Pt,-Pt)}function Sv(y){
let M=!0;return T.forEach((P,L)=>{if(!P.show)return;let k=_[P.scale];if(k.min==null){P._show&&(M=!1,P._show=!1,Er(!1));return}else P._show||(M=!1,P._show=!0,Er(!1));let Y=P.side,it=Y%2,{min:lt,max:mt}=k,[Ct,Pt]=Mv(L,lt,mt,it==0?x:N);if(Pt==0)return;let Nt=k.distr==2,oe=P._splits=P.splits(n,L,lt,mt,Ct,Pt,Nt),Te=k.distr==2?oe.map(Xt=>$[Xt]):oe,Se=k.distr==2?$[oe[1]]-$[oe[0]]:Ct,fe=P._values=P.values(
n,P.filter(n,Te,L,Pt,Se),L,Pt,Se);P._rotate=Y==2?P.rotate(n,fe,L,Pt):0;let ee=P._size;P._size=gi(P.size(n,fe,L,y)),ee!=null&&P._size!=ee&&(M=!1)}),M}function wv(y){let M=!0;return $a.forEach((P,L)=>{let k=P(n,L,Zi,y);k!=Fi[L]&&(M=!1),Fi[L]=k}),M}function Ev(){for(let y=0;y<T.length;y++){let M=T[y];if(!M.show||!M._show)continue;let P=M.side,L=P%2,k,Y,it=M.stroke(n,y),lt=P==0||P==3?-1:1,[mt,Ct]=M._found;
if(M.label!=null){let Bn=M.labelGap*lt,Jn=un((M._lpos+Bn)*Ce);ze(M.labelFont[0],it,"center",P==2?"top":Xg),h.save(),L==1?(k=Y=0,h.translate(Jn,un(at+Gt/2)),h.rotate((P==3?-Dh:Dh)/2)):(k=un(Rt+gt/2),Y=Jn);let Zs=U0(M.label)?M.label(n,y,mt,Ct):M.label;h.fillText(Zs,k,Y),h.restore()}if(Ct==0)continue;let Pt=_[M.scale],Nt=L==0?gt:Gt,oe=L==0?Rt:at,Te=M._splits,Se=Pt.distr==2?Te.map(Bn=>$[Bn]):Te,fe=Pt.
distr==2?$[Te[1]]-$[Te[0]]:mt,ee=M.ticks,Xt=M.border,qe=ee.show?ee.size:0,en=un(qe*Ce),yn=un((M.alignTo==2?M._size-qe-M.gap:M.gap)*Ce),Fe=M._rotate*-Dh/180,nn=m(M._pos*Ce),$n=(en+yn)*lt,On=nn+$n;Y=L==0?On:0,k=L==1?On:0;let ai=M.font[0],yi=M.align==1?Ro:M.align==2?qf:Fe>0?Ro:Fe<0?qf:L==0?"center":P==3?qf:Ro,Bi=Fe||L==1?"middle":P==2?"top":Xg;ze(ai,it,yi,Bi);let Zn=M.font[1]*M.lineGap,li=Te.map(Bn=>m(
a(Bn,Pt,Nt,oe))),xi=M._values;for(let Bn=0;Bn<xi.length;Bn++){let Jn=xi[Bn];if(Jn!=null){L==0?k=li[Bn]:Y=li[Bn],Jn=""+Jn;let Zs=Jn.indexOf(`
`)==-1?[Jn]:Jn.split(/\n/gm);for(let kn=0;kn<Zs.length;kn++){let Xd=Zs[kn];Fe?(h.save(),h.translate(k,Y+kn*Zn),h.rotate(Fe),h.fillText(Xd,0,0),h.restore()):h.fillText(Xd,k,Y+kn*Zn)}}}ee.show&&qh(li,ee.filter(n,Se,y,Ct,fe),L,P,nn,en,Be(ee.width*Ce,3),ee.stroke(n,y),ee.dash,ee.cap);let ki=M.grid;ki.show&&qh(li,ki.filter(n,Se,y,Ct,fe),L,L==0?2:1,L==0?at:Rt,L==0?Gt:gt,Be(ki.width*Ce,3),ki.stroke(n,y),
ki.dash,ki.cap),Xt.show&&qh([nn],[1],L==0?1:0,L==0?1:2,L==1?at:Rt,L==1?Gt:gt,Be(Xt.width*Ce,3),Xt.stroke(n,y),Xt.dash,Xt.cap)}vn("drawAxes")}function Er(y){b.forEach((M,P)=>{P>0&&(M._paths=null,y&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let Za=!1,Yh=!1,zo=[];function Tv(){Yh=!1;for(let y=0;y<zo.length;y++)vn(...zo[y]);zo.length=0}function Tr(){Za||(G1(Ad),Za=
!0)}function Av(y,M=!1){Za=!0,Yh=M,y(n),Ad(),M&&zo.length>0&&queueMicrotask(Tv)}n.batch=Av;function Ad(){if(Ht&&(gs(),Ht=!1),ie&&(Vt(),ie=!1),Mt){if(Je(d,Ro,J),Je(d,"top",nt),Je(d,Ba,x),Je(d,ka,N),Je(g,Ro,J),Je(g,"top",nt),Je(g,Ba,x),Je(g,ka,N),Je(f,Ba,Ee),Je(f,ka,I),u.width=un(Ee*Ce),u.height=un(I*Ce),T.forEach(({_el:y,_show:M,_size:P,_pos:L,side:k})=>{if(y!=null)if(M){let Y=k===3||k===0?P:0,it=k%
2==1;Je(y,it?"left":"top",L-Y),Je(y,it?"width":"height",P),Je(y,it?"top":"left",it?nt:J),Je(y,it?"height":"width",it?N:x),ed(y,br)}else ii(y,br)}),Ft=At=Jt=Wt=he=Me=ke=Le=Qt=null,ae=1,Go(!0),J!=et||nt!=Bt||x!=ht||N!=Ut){Er(!1);let y=x/ht,M=N/Ut;if(Kt&&!B&&pt.left>=0){pt.left*=y,pt.top*=M,Ar&&Yi(Ar,un(pt.left),0,x,N),Cr&&Yi(Cr,0,un(pt.top),x,N);for(let P=0;P<Un.length;P++){let L=Un[P];L!=null&&($i[P]*=
y,vi[P]*=M,Yi(L,gi($i[P]),gi(vi[P]),x,N))}}if(Xe.show&&!ut&&Xe.left>=0&&Xe.width>0){Xe.left*=y,Xe.width*=y,Xe.top*=M,Xe.height*=M;for(let P in Qh)Je(Ir,P,Xe[P])}et=J,Bt=nt,ht=x,Ut=N}vn("setSize"),Mt=!1}Ee>0&&I>0&&(h.clearRect(0,0,u.width,u.height),vn("drawClear"),F.forEach(y=>y()),vn("draw")),Xe.show&&ut&&(Ja(Xe),ut=!1),Kt&&B&&($s(null,!0,!1),B=!1),bt.show&&bt.live&&dt&&(Kh(),dt=!1),l||(l=!0,n.status=
1,vn("ready")),G=!1,Za=!1}n.redraw=(y,M)=>{ie=M||!1,y!==!1?xs(A,R.min,R.max):Tr()};function $h(y,M){let P=_[y];if(P.from==null){if(ln==0){let L=P.range(n,M.min,M.max,y);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(ln>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;y==A&&P.distr==2&&ln>0&&(M.min=Li(M.min,t[0]),M.max=Li(M.max,t[0]),M.min==M.max&&M.max++),X[y]=M,Ht=!0,
Tr()}}n.setScale=$h;let Zh,Jh,Ar,Cr,Cd,Rd,Rr,Pr,Pd,Id,We,Ke,ys=!1,Sn=pt.drag,mn=Sn.x,gn=Sn.y;Kt&&(pt.x&&(Zh=mi(d1,g)),pt.y&&(Jh=mi(p1,g)),R.ori==0?(Ar=Zh,Cr=Jh):(Ar=Jh,Cr=Zh),We=pt.left,Ke=pt.top);let Xe=n.select=an({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ir=Xe.show?mi(f1,Xe.over?g:d):null;function Ja(y,M){if(Xe.show){for(let P in y)Xe[P]=y[P],P in Qh&&Je(Ir,P,y[P]);M!==!1&&vn("s\
etSelect")}}n.setSelect=Ja;function Cv(y){if(b[y].show)se&&ed(xt[y],br);else if(se&&ii(xt[y],br),Kt){let P=Ui?Un[0]:Un[y];P!=null&&Yi(P,-10,-10,x,N)}}function xs(y,M,P){$h(y,{min:M,max:P})}function Ni(y,M,P,L){M.focus!=null&&Dv(y),M.show!=null&&b.forEach((k,Y)=>{Y>0&&(y==Y||y==null)&&(k.show=M.show,Cv(Y),s==2?(xs(k.facets[0].scale,null,null),xs(k.facets[1].scale,null,null)):xs(k.scale,null,null),Tr())}),
P!==!1&&vn("setSeries",y,M),L&&Wo("setSeries",n,y,M)}n.setSeries=Ni;function Rv(y,M){an(C[y],M)}function Pv(y,M){y.fill=ve(y.fill||null),y.dir=we(y.dir,-1),M=M??C.length,C.splice(M,0,y)}function Iv(y){y==null?C.length=0:C.splice(y,1)}n.addBand=Pv,n.setBand=Rv,n.delBand=Iv;function Lv(y,M){b[y].alpha=M,Kt&&Un[y]!=null&&(Un[y].style.opacity=M),se&&xt[y]&&(xt[y].style.opacity=M)}let Ji,_s,Ys,Lr={focus:!0};
function Dv(y){if(y!=Ys){let M=y==null,P=Yn.alpha!=1;b.forEach((L,k)=>{if(s==1||k>0){let Y=M||k==0||k==y;L._focus=M?null:Y,P&&Lv(k,Y?1:Yn.alpha)}}),Ys=y,P&&Tr()}}se&&Hn&&qt(Zg,tt,y=>{pt._lock||(Mn(y),Ys!=null&&Ni(null,Lr,!0,sn.setSeries))});function Oi(y,M,P){let L=_[M];P&&(y=y/Ce-(L.ori==1?nt:J));let k=x;L.ori==1&&(k=N,y=k-y),L.dir==-1&&(y=k-y);let Y=L._min,it=L._max,lt=y/k,mt=Y+(it-Y)*lt,Ct=L.distr;
return Ct==3?Lo(10,mt):Ct==4?I1(mt,L.asinh):Ct==100?L.bwd(mt):mt}function Uv(y,M){let P=Oi(y,A,M);return Li(P,t[0],E,V)}n.valToIdx=y=>Li(y,t[0]),n.posToIdx=Uv,n.posToVal=Oi,n.valToPos=(y,M,P)=>_[M].ori==0?r(y,_[M],P?gt:x,P?Rt:0):o(y,_[M],P?Gt:N,P?at:0),n.setCursor=(y,M,P)=>{We=y.left,Ke=y.top,$s(null,M,P)};function Ld(y,M){Je(Ir,Ro,Xe.left=y),Je(Ir,Ba,Xe.width=M)}function Dd(y,M){Je(Ir,"top",Xe.top=
y),Je(Ir,ka,Xe.height=M)}let Vo=R.ori==0?Ld:Dd,Ho=R.ori==1?Ld:Dd;function Fv(){if(se&&bt.live)for(let y=s==2?1:0;y<b.length;y++){if(y==0&&U)continue;let M=bt.values[y],P=0;for(let L in M)ne[y][P++].firstChild.nodeValue=M[L]}}function Kh(y,M){if(y!=null&&(y.idxs?y.idxs.forEach((P,L)=>{vt[L]=P}):F1(y.idx)||vt.fill(y.idx),bt.idx=vt[0]),se&&bt.live){for(let P=0;P<b.length;P++)(P>0||s==1&&!U)&&Nv(P,vt[P]);
Fv()}dt=!1,M!==!1&&vn("setLegend")}n.setLegend=Kh;function Nv(y,M){let P=b[y],L=y==0&&O==2?$:t[y],k;U?k=P.values(n,y,M)??xe:(k=P.value(n,M==null?null:L[M],y,M),k=k==null?xe:{_:k}),bt.values[y]=k}function $s(y,M,P){Pd=We,Id=Ke,[We,Ke]=pt.move(n,We,Ke),pt.left=We,pt.top=Ke,Kt&&(Ar&&Yi(Ar,un(We),0,x,N),Cr&&Yi(Cr,0,un(Ke),x,N));let L,k=E>V;Ji=Oe,_s=null;let Y=R.ori==0?x:N,it=R.ori==1?x:N;if(We<0||ln==
0||k){L=pt.idx=null;for(let lt=0;lt<b.length;lt++){let mt=Un[lt];mt!=null&&Yi(mt,-10,-10,x,N)}Hn&&Ni(null,Lr,!0,y==null&&sn.setSeries),bt.live&&(vt.fill(L),dt=!0)}else{let lt,mt,Ct;s==1&&(lt=R.ori==0?We:Ke,mt=Oi(lt,A),L=pt.idx=Li(mt,t[0],E,V),Ct=z(t[0][L],R,Y,0));let Pt=-10,Nt=-10,oe=0,Te=0,Se=!0,fe="",ee="";for(let Xt=s==2?1:0;Xt<b.length;Xt++){let qe=b[Xt],en=vt[Xt],yn=en==null?null:s==1?t[Xt][en]:
t[Xt][1][en],Fe=pt.dataIdx(n,Xt,L,mt),nn=Fe==null?null:s==1?t[Xt][Fe]:t[Xt][1][Fe];if(dt=dt||nn!=yn||Fe!=en,vt[Xt]=Fe,Xt>0&&qe.show){let $n=Fe==null?-10:Fe==L?Ct:z(s==1?t[0][Fe]:t[Xt][0][Fe],R,Y,0),On=nn==null?-10:W(nn,s==1?_[qe.scale]:_[qe.facets[1].scale],it,0);if(Hn&&nn!=null){let ai=R.ori==1?We:Ke,yi=fn(Yn.dist(n,Xt,Fe,On,ai));if(yi<Ji){let Bi=Yn.bias;if(Bi!=0){let Zn=Oi(ai,qe.scale),li=nn>=0?
1:-1,xi=Zn>=0?1:-1;xi==li&&(xi==1?Bi==1?nn>=Zn:nn<=Zn:Bi==1?nn<=Zn:nn>=Zn)&&(Ji=yi,_s=Xt)}else Ji=yi,_s=Xt}}if(dt||Ui){let ai,yi;R.ori==0?(ai=$n,yi=On):(ai=On,yi=$n);let Bi,Zn,li,xi,ki,Bn,Jn=!0,Zs=Ne.bbox;if(Zs!=null){Jn=!1;let kn=Zs(n,Xt);li=kn.left,xi=kn.top,Bi=kn.width,Zn=kn.height}else li=ai,xi=yi,Bi=Zn=Ne.size(n,Xt);if(Bn=Ne.fill(n,Xt),ki=Ne.stroke(n,Xt),Ui)Xt==_s&&Ji<=Yn.prox&&(Pt=li,Nt=xi,oe=
Bi,Te=Zn,Se=Jn,fe=Bn,ee=ki);else{let kn=Un[Xt];kn!=null&&($i[Xt]=li,vi[Xt]=xi,n0(kn,Bi,Zn,Jn),t0(kn,Bn,ki),Yi(kn,gi(li),gi(xi),x,N))}}}}if(Ui){let Xt=Yn.prox,qe=Ys==null?Ji<=Xt:Ji>Xt||_s!=Ys;if(dt||qe){let en=Un[0];en!=null&&($i[0]=Pt,vi[0]=Nt,n0(en,oe,Te,Se),t0(en,fe,ee),Yi(en,gi(Pt),gi(Nt),x,N))}}}if(Xe.show&&ys)if(y!=null){let[lt,mt]=sn.scales,[Ct,Pt]=sn.match,[Nt,oe]=y.cursor.sync.scales,Te=y.
cursor.drag;if(mn=Te._x,gn=Te._y,mn||gn){let{left:Se,top:fe,width:ee,height:Xt}=y.select,qe=y.scales[Nt].ori,en=y.posToVal,yn,Fe,nn,$n,On,ai=lt!=null&&Ct(lt,Nt),yi=mt!=null&&Pt(mt,oe);ai&&mn?(qe==0?(yn=Se,Fe=ee):(yn=fe,Fe=Xt),nn=_[lt],$n=z(en(yn,Nt),nn,Y,0),On=z(en(yn+Fe,Nt),nn,Y,0),Vo(Di($n,On),fn(On-$n))):Vo(0,Y),yi&&gn?(qe==1?(yn=Se,Fe=ee):(yn=fe,Fe=Xt),nn=_[mt],$n=W(en(yn,oe),nn,it,0),On=W(en(
yn+Fe,oe),nn,it,0),Ho(Di($n,On),fn(On-$n))):Ho(0,it)}else tu()}else{let lt=fn(Pd-Cd),mt=fn(Id-Rd);if(R.ori==1){let oe=lt;lt=mt,mt=oe}mn=Sn.x&&lt>=Sn.dist,gn=Sn.y&&mt>=Sn.dist;let Ct=Sn.uni;Ct!=null?mn&&gn&&(mn=lt>=Ct,gn=mt>=Ct,!mn&&!gn&&(mt>lt?gn=!0:mn=!0)):Sn.x&&Sn.y&&(mn||gn)&&(mn=gn=!0);let Pt,Nt;mn&&(R.ori==0?(Pt=Rr,Nt=We):(Pt=Pr,Nt=Ke),Vo(Di(Pt,Nt),fn(Nt-Pt)),gn||Ho(0,it)),gn&&(R.ori==1?(Pt=Rr,
Nt=We):(Pt=Pr,Nt=Ke),Ho(Di(Pt,Nt),fn(Nt-Pt)),mn||Vo(0,Y)),!mn&&!gn&&(Vo(0,0),Ho(0,0))}if(Sn._x=mn,Sn._y=gn,y==null){if(P){if(Wd!=null){let[lt,mt]=sn.scales;sn.values[0]=lt!=null?Oi(R.ori==0?We:Ke,lt):null,sn.values[1]=mt!=null?Oi(R.ori==1?We:Ke,mt):null}Wo(Yf,n,We,Ke,x,N,L)}if(Hn){let lt=P&&sn.setSeries,mt=Yn.prox;Ys==null?Ji<=mt&&Ni(_s,Lr,!0,lt):Ji>mt?Ni(null,Lr,!0,lt):_s!=Ys&&Ni(_s,Lr,!0,lt)}}dt&&
(bt.idx=L,Kh()),M!==!1&&vn("setCursor")}let bs=null;Object.defineProperty(n,"rect",{get(){return bs==null&&Go(!1),bs}});function Go(y=!1){y?bs=null:(bs=g.getBoundingClientRect(),vn("syncRect",bs))}function Ud(y,M,P,L,k,Y,it){pt._lock||ys&&y!=null&&y.movementX==0&&y.movementY==0||(jh(y,M,P,L,k,Y,it,!1,y!=null),y!=null?$s(null,!0,!0):$s(M,!0,!1))}function jh(y,M,P,L,k,Y,it,lt,mt){if(bs==null&&Go(!1),
Mn(y),y!=null)P=y.clientX-bs.left,L=y.clientY-bs.top;else{if(P<0||L<0){We=-10,Ke=-10;return}let[Ct,Pt]=sn.scales,Nt=M.cursor.sync,[oe,Te]=Nt.values,[Se,fe]=Nt.scales,[ee,Xt]=sn.match,qe=M.axes[0].side%2==1,en=R.ori==0?x:N,yn=R.ori==1?x:N,Fe=qe?Y:k,nn=qe?k:Y,$n=qe?L:P,On=qe?P:L;if(Se!=null?P=ee(Ct,Se)?a(oe,_[Ct],en,0):-10:P=en*($n/Fe),fe!=null?L=Xt(Pt,fe)?a(Te,_[Pt],yn,0):-10:L=yn*(On/nn),R.ori==1){
let ai=P;P=L,L=ai}}mt&&(M==null||M.cursor.event.type==Yf)&&((P<=1||P>=x-1)&&(P=xr(P,x)),(L<=1||L>=N-1)&&(L=xr(L,N))),lt?(Cd=P,Rd=L,[Rr,Pr]=pt.move(n,P,L)):(We=P,Ke=L)}let Qh={width:0,height:0,left:0,top:0};function tu(){Ja(Qh,!1)}let Fd,Nd,Od,Bd;function kd(y,M,P,L,k,Y,it){ys=!0,mn=gn=Sn._x=Sn._y=!1,jh(y,M,P,L,k,Y,it,!0,!1),y!=null&&(qt($f,Qf,zd,!1),Wo(Yg,n,Rr,Pr,x,N,null));let{left:lt,top:mt,width:Ct,
height:Pt}=Xe;Fd=lt,Nd=mt,Od=Ct,Bd=Pt}function zd(y,M,P,L,k,Y,it){ys=Sn._x=Sn._y=!1,jh(y,M,P,L,k,Y,it,!1,!0);let{left:lt,top:mt,width:Ct,height:Pt}=Xe,Nt=Ct>0||Pt>0,oe=Fd!=lt||Nd!=mt||Od!=Ct||Bd!=Pt;if(Nt&&oe&&Ja(Xe),Sn.setScale&&Nt&&oe){let Te=lt,Se=Ct,fe=mt,ee=Pt;if(R.ori==1&&(Te=mt,Se=Pt,fe=lt,ee=Ct),mn&&xs(A,Oi(Te,A),Oi(Te+Se,A)),gn)for(let Xt in _){let qe=_[Xt];Xt!=A&&qe.from==null&&qe.min!=Oe&&
xs(Xt,Oi(fe+ee,Xt),Oi(fe,Xt))}tu()}else pt.lock&&(pt._lock=!pt._lock,$s(M,!0,y!=null));y!=null&&(Ge($f,Qf),Wo($f,n,We,Ke,x,N,null))}function Ov(y,M,P,L,k,Y,it){if(pt._lock)return;Mn(y);let lt=ys;if(ys){let mt=!0,Ct=!0,Pt=10,Nt,oe;R.ori==0?(Nt=mn,oe=gn):(Nt=gn,oe=mn),Nt&&oe&&(mt=We<=Pt||We>=x-Pt,Ct=Ke<=Pt||Ke>=N-Pt),Nt&&mt&&(We=We<Rr?0:x),oe&&Ct&&(Ke=Ke<Pr?0:N),$s(null,!0,!0),ys=!1}We=-10,Ke=-10,vt.
fill(null),$s(null,!0,!0),lt&&(ys=lt)}function Vd(y,M,P,L,k,Y,it){pt._lock||(Mn(y),Et(),tu(),y!=null&&Wo(Jg,n,We,Ke,x,N,null))}function Hd(){T.forEach(Kw),Dt(n.width,n.height,!0)}Mr(Uh,Io,Hd);let Dr={};Dr.mousedown=kd,Dr.mousemove=Ud,Dr.mouseup=zd,Dr.dblclick=Vd,Dr.setSeries=(y,M,P,L)=>{let k=sn.match[2];P=k(n,M,P),P!=-1&&Ni(P,L,!0,!1)},Kt&&(qt(Yg,g,kd),qt(Yf,g,Ud),qt($g,g,y=>{Mn(y),Go(!1)}),qt(Zg,
g,Ov),qt(Jg,g,Vd),ad.add(n),n.syncRect=Go);let Ka=n.hooks=i.hooks||{};function vn(y,M,P){Yh?zo.push([y,M,P]):y in Ka&&Ka[y].forEach(L=>{L.call(null,n,M,P)})}(i.plugins||[]).forEach(y=>{for(let M in y.hooks)Ka[M]=(Ka[M]||[]).concat(y.hooks[M])});let Gd=(y,M,P)=>P,sn=an({key:null,setSeries:!1,filters:{pub:a0,sub:a0},scales:[A,b[1]?b[1].scale:null],match:[l0,l0,Gd],values:[null,null]},pt.sync);sn.match.
length==2&&sn.match.push(Gd),pt.sync=sn;let Wd=sn.key,eu=sv(Wd);function Wo(y,M,P,L,k,Y,it){sn.filters.pub(y,M,P,L,k,Y,it)&&eu.pub(y,M,P,L,k,Y,it)}eu.sub(n);function Bv(y,M,P,L,k,Y,it){sn.filters.sub(y,M,P,L,k,Y,it)&&Dr[y](null,M,P,L,k,Y,it)}n.pub=Bv;function kv(){eu.unsub(n),ad.delete(n),Lt.clear(),nd(Uh,Io,Hd),c.remove(),tt?.remove(),vn("destroy")}n.destroy=kv;function nu(){vn("init",i,t),ft(t||
i.data,!1),X[A]?$h(A,X[A]):Et(),ut=Xe.show&&(Xe.width>0||Xe.height>0),B=dt=!0,Dt(i.width,i.height)}return b.forEach(Ws),T.forEach(Xh),e?e instanceof HTMLElement?(e.appendChild(c),nu()):e(n,nu):nu(),n}bn.assign=an;bn.fmtNum=pd;bn.rangeNum=Fh;bn.rangeLog=Bh;bn.rangeAsinh=fd;bn.orient=wr;bn.pxRatio=Ce;bn.join=H1;bn.fmtDate=gd,bn.tzDate=Q1;bn.sync=sv;{bn.addGap=Fw,bn.clipGaps=Vh;let i=bn.paths={points:hv};
i.linear=fv,i.stepped=Bw,i.bars=kw,i.spline=Vw}function Sd(i,t,e){let n=document.createElement("a");n.href=URL.createObjectURL(new Blob([e],{type:t})),n.download=i,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),1e3)}var wd=i=>(i.title??i.curves.map(t=>t.name).join("_")).replace(/[^\w.-]+/g,"_").slice(0,60),jw=i=>/[",\n]/.test(i)?`"${i.replace(/"/g,'""')}"`:i;function gv(i){let t=new Map;i.curves.forEach((r,o)=>{for(let a=0,l=0;a<r.t.length;++a){
l=a>0&&r.t[a]===r.t[a-1]?l+1:0;let c=`${r.t[a]} ${l}`,u=t.get(c)??{t:r.t[a],before:l,values:new Array(i.curves.length).fill(void 0)};u.values[o]=r.y[a],t.set(c,u)}});let e=["t [s]",...i.curves.map(r=>i.unit?`${r.name} [${i.unit}]`:r.name)].map(jw).join(","),s=[...t.values()].sort((r,o)=>r.t-o.t||r.before-o.before).map(({t:r,values:o})=>[r,...o.map(a=>a??"")].join(","));return`${[e,...s].join(`
`)}
`}var Qw=i=>i.replace(/&/g,"&amp;").replace(/</g,"&lt;").replace(/>/g,"&gt;").replace(/"/g,"&quot;");function vv(i,t,e,n){let u=C=>i.log?C>0?Math.log10(C):NaN:C,h=1/0,f=-1/0;i.curves.forEach((C,A)=>{for(let D=0;t[A]&&D<C.t.length;++D){let F=u(C.y[D]);C.t[D]<e||C.t[D]>n||!Number.isFinite(F)||(h=Math.min(h,F),f=Math.max(f,F))}}),h<=f||(h=0,f=1);let d=f>h?.06*(f-h):Math.abs(f)*.1||1;h-=d,f+=d;let g=C=>70+
634*(C-e)/(n-e||1),v=C=>260-230*(C-h)/(f-h),m=(C,A,D,F,w="#5f6c7b")=>`<text x="${C.toFixed(1)}" y="${A.toFixed(1)}" text-anchor="${F}" fill="${w}">${Qw(D)}</text>`,p=[],b=ji(e,n,8),T=ji(h,f,6);for(let C of b.values)p.push(`<path d="M${g(C).toFixed(1)} 30V260" stroke="#e3e7ec"/>`,m(g(C),276,ou(C,b.step),"middle"));for(let C of T.values)p.push(`<path d="M70 ${v(C).toFixed(1)}H704" stroke="#e3e7ec"/>`,
m(62,v(C)+4,i.log?He(10**C):ou(C,T.step),"end"));let _=70;return i.curves.forEach((C,A)=>{if(!t[A])return;let D="",F="M";for(let S=0;S<C.t.length;++S){let R=u(C.y[S]);if(!(C.t[S]<e||C.t[S]>n)){if(!Number.isFinite(R)){F="M";continue}D+=`${F}${g(C.t[S]).toFixed(1)} ${v(R).toFixed(1)}`,F="L"}}let w=Qi[(C.colour??A)%Qi.length];p.push(`<path d="${D}" fill="none" stroke="${w}" stroke-width="1.5"${C.dashed?
' stroke-dasharray="5 4"':""}/>`,`<path d="M${_} 14h22" fill="none" stroke="${w}" stroke-width="1.5"${C.dashed?' stroke-dasharray="5 4"':""}/>`,m(_+27,18,C.name,"start",w)),_+=7.2*C.name.length+45}),p.push(m(704,292,"t [s]","end"),m(704,18,i.unit?`[${i.unit}]`:"","end")),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 300" width="720" height="300" font-family="sans-serif" font-size="12">\
<rect width="720" height="300" fill="#fff"/>${p.join(`
`)}</svg>
`}function Td(i){let t=[],e=n=>n.includes(".")?n.slice(0,n.lastIndexOf(".")):n;for(let n of i){let s=n.unit&&t.find(r=>r.unit===n.unit&&e(r.curves[0].name)===e(n.name)&&r.curves.length<Qi.length);s?s.curves.push(n):t.push({unit:n.unit,curves:[n]})}return t}var _v=["open","separating","stick","slip","lower","upper","locked"],Ed=i=>i.name.endsWith(".status"),tE=(i,t)=>Ed(i)&&_v[t]||He(t),eE="11px syst\
em-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",yv=i=>jt.dark?Ye(Qi[i%Qi.length],.25):Qi[i%Qi.length];function xv(i){let t=n=>Array.from(n,s=>Number.isFinite(s)?i.log?s>0?s:null:s:null);return i.curves.every(n=>n.t===i.curves[0].t)?[Array.from(i.curves[0].t),...i.curves.map(n=>t(n.y))]:bn.join(i.curves.map(n=>[nE(n.t),t(n.y)]))}function nE(i){let t=Array.from(i),e=1e-12*Math.abs(t[t.length-
1]??0);for(let n=1;n<t.length;++n)t[n]<=t[n-1]&&(t[n]=t[n-1]+e);return t}var iE=60,Wa=class{constructor(t,e,n,s,r){this.box=t;this.panels=e;this.begin=n;this.end=s;this.seek=r;this.most=iE;this.shown=[];this.zoomed=null;this.syncing=!1;this.t=0}rebuild(){for(let e of this.shown)e.plot.destroy();this.shown=[],this.box.replaceChildren();let t=this.box.clientWidth;if(t){for(let e of this.panels.slice(
0,this.most))this.shown.push(this.add(e,t));this.panels.length>this.most&&this.box.append(this.moreButton()),this.zoomed&&this.zoom(...this.zoomed),this.draw(this.t)}}moreButton(){let t=document.createElement("button");return t.className="more",t.textContent=`show ${this.panels.length-this.most} more plots`,t.onclick=()=>{this.most=1/0,this.rebuild()},t}setPanels(t,e=this.begin,n=this.end){this.panels=
t,this.begin=e,this.end=n,this.built&&this.rebuild()}grow(t,e,n){this.begin=t,this.end=e;let s=!n||n.length===this.panels.length&&n.every((r,o)=>r.curves.length===this.panels[o].curves.length);if(n&&(this.panels=n),!!this.built){if(!s){this.rebuild();return}this.syncing=!0,this.shown.forEach((r,o)=>{r.panel=this.panels[o],r.plot.setData(xv(r.panel),!1),r.plot.setScale("x",this.zoomed?{min:this.zoomed[0],
max:this.zoomed[1]}:{min:t,max:e>t?e:t+1})}),this.syncing=!1,this.draw(this.t)}}get built(){return this.shown.length>0}resize(){let t=this.box.clientWidth;if(t){if(!this.built){this.rebuild();return}for(let e of this.shown)e.plot.setSize({width:t,height:e.plot.height});this.draw(this.t)}}add(t,e){let n=document.createElement("div"),s=document.createElement("div");if(n.className="plot",s.className=
"names",t.title){let u=document.createElement("b");u.textContent=t.title,s.append(u)}let r=t.curves.map((u,h)=>{let f=document.createElement("span"),d=document.createElement("em");return f.textContent=u.name,f.style.color=yv(u.colour??h),f.title="show or hide",f.onclick=()=>{let g=!a.series[h+1].show;a.setSeries(h+1,{show:g}),f.classList.toggle("off",!g)},f.append(d),s.append(f),d});if(t.unit){let u=document.
createElement("small");u.textContent=`[${t.unit}]`,s.append(u)}let o=document.createElement("span");o.className="files";for(let[u,h,f]of[["CSV","save the numbers of these curves as CSV",()=>Sd(`${wd(t)}.csv`,"text/csv",gv(c.panel))],["SVG","save this plot as SVG",()=>Sd(`${wd(t)}.svg`,"image/svg+xml",vv(c.panel,c.panel.curves.map((d,g)=>a.series[g+1].show!==!1),a.scales.x.min??0,a.scales.x.max??1))]]){
let d=document.createElement("button");d.textContent=u,d.title=h,d.onclick=f,o.append(d)}s.append(o),n.append(s),this.box.append(n);let a=new bn(this.options(t,e),xv(t),n),l=document.createElement("div");l.className="now",a.over.append(l);let c={plot:a,panel:t,values:r,line:l};return c}options(t,e){let n={font:eE,stroke:jt.soft,grid:{stroke:jt.grid,width:1},ticks:{show:!1}},s=a=>a===null?"":He(a),
r=t.curves.every(Ed),o=a=>r?_v[a]??"":s(a);return{width:e,height:t.height??138,padding:[6,14,0,0],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,dist:6},bind:{dblclick:()=>()=>(this.zoom(this.begin,this.end),null)}},scales:{x:{time:!1,min:this.begin,max:this.end>this.begin?this.end:this.begin+1},y:t.log?{distr:3}:{range:(a,l,c)=>sE(l,c)}},axes:[{...n,size:26,gap:4,values:(a,l)=>l.map(
s)},{...n,size:this.panels.some(a=>a.curves.every(Ed))?76:58,gap:4,values:(a,l)=>l.map(o),space:t.log?18:24}],series:[{},...t.curves.map((a,l)=>({stroke:yv(a.colour??l),width:1.5,spanGaps:!0,points:{show:!1},dash:a.dashed?[5,4]:void 0}))],hooks:{setScale:[(a,l)=>{l!=="x"||this.syncing||a.scales.x.min==null||a.scales.x.max==null||this.shown.length&&this.zoom(a.scales.x.min,a.scales.x.max)}],ready:[
a=>{a.over.addEventListener("click",l=>{a.select.width>0||this.seek(wn(a.posToVal(l.offsetX,"x"),this.begin,this.end))})}]}}}zoom(t,e){this.syncing=!0,this.zoomed=t<=this.begin&&e>=this.end?null:[t,e];for(let{plot:n}of this.shown)n.setScale("x",{min:t,max:e}),n.setSelect({left:0,top:0,width:0,height:0},!1);this.syncing=!1,this.draw(this.t),this.box.classList.toggle("zoomed",this.zoomed!==null)}draw(t){
this.t=t;for(let{plot:e,panel:n,values:s,line:r}of this.shown){let o=e.valToPos(t,"x");r.hidden=!(o>=-1&&o<=e.over.clientWidth+1),r.style.transform=`translateX(${Math.round(o)}px)`,n.curves.forEach((a,l)=>{s[l].textContent=tE(a,a.t.length?a.y[zi(a.t,t)]:NaN)})}}};function sE(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(i),Math.abs(t));if(t-
i<=1e-9*e||t===i)return e===0?[-1,1]:[i-.1*e,t+.1*e];let n=.07*(t-i);return[i-n,t+n]}var kt=i=>document.getElementById(i),Xa=class{constructor(t,e,n,s,r,o,a,l=!1){this.data=t;this.scene=e;this.film=n;this.signals=s;this.events=r;this.ledger=o;this.grows=l;this.studio=new Rh(this);this.live=null;this.playing=!1;this.queued=!1;this.tab="";this.sizes="";this.named={};[this.begin,this.end]=Ss(n,s),this.t=this.begin;let c=a.get("theme");fu(c?c==="dark":matchMedia("(prefers-color-scheme\
: dark)").matches),document.documentElement.classList.toggle("dark",jt.dark),this.model=new Cs(e,n);let u={redraw:()=>this.draw(),selected:g=>this.select(g),clicked:()=>!1};this.stage=new Ao(kt("stage"),this.model,{...u,clicked:(g,v)=>this.tools.clicked(g,v,this.t)},a.get("webgl")),this.tools=new _l(this.stage,e,()=>this.draw()),this.comparison=new wh(this,u,a.get("webgl"),a.get("beside")==="1");let h=e.
follow??-1;this.stage.follow(h<n.poses?h:-1,this.t);let f=g=>{this.pause().seek(g)};this.plots=new Wa(kt("plots"),Td(s),this.begin,this.end,f),this.energy=new Wa(kt("energy"),this.comparison.ledger(o),this.begin,this.end,f),this.list=new ll(kt("events"),r,Number(t.run?.eventsLeftOut??0),f);let d=document.querySelector("main");d.classList.toggle("alone",!l&&!s.length&&!t.model.text&&!t.run),d.classList.
toggle("unseen",!e.shapes.length&&s.length>0),this.fillPanels(o.size>0),this.addTransport(),this.addTools(),document.addEventListener("keydown",g=>this.key(g)),new ResizeObserver(()=>this.resize()).observe(kt("stage")),new ResizeObserver(()=>this.resize()).observe(kt("side")),window.addEventListener("hashchange",()=>bu(this,new URLSearchParams(location.hash.slice(1)))),this.comparison.resize(),this.
setView(this.model.naturalView()),this.resize(),bu(this,a)}grow(t,e){let{film:n,stage:s}=this,r=n.count<40&&!s.touched;if(this.end=Math.max(this.end,n.end),r&&this.model.naturalView()!==s.camera.view&&this.setView(this.model.naturalView()),!!e){this.model.remeasure()&&(s.space?.remeasured(),s.touched||s.fit()),s.overlay.usualForce=n.usualForce(),s.overlay.usualImpact=n.usualImpact(),this.plots.grow(
this.begin,this.end),this.ledger=t.ledgerColumns(),this.energy.grow(this.begin,this.end,this.comparison.ledger(this.ledger)),this.list.take(this.comparison.events(this.events));for(let o of["before","after"])kt(o).disabled=!this.events.length;this.comparison.showHead(),this.fillLegend(),this.comparison.paintMarks(this.events),this.draw()}}ended(t){this.data.run=t,this.comparison.showHead(),kt("run").
replaceChildren(...[mu(t),pu(t)].filter(e=>e!==null)),this.addTab("run","Run"),this.draw()}get title(){let{run:t,title:e}=this.data;return t&&typeof t.title=="string"&&t.title?t.title:e}seek(t){return this.t=wn(t,this.begin,this.end),this.draw(),this}play(){if(this.playing)return;this.live&&(this.live.atEdge=!1),this.t>=this.end&&(this.t=this.begin),this.playing=!0,kt("play").innerHTML=cp;let t=performance.
now(),e=n=>{if(!this.playing)return;let s=this.t+(n-t)/1e3*Number(kt("speed").value);t=n,s>this.end&&(kt("loop").checked&&this.end>this.begin?s=this.begin+(s-this.begin)%(this.end-this.begin):this.pause()),this.seek(s),this.playing&&requestAnimationFrame(e)};requestAnimationFrame(e)}pause(t=!0){return t&&this.live&&(this.live.atEdge=!1),this.playing=!1,kt("play").innerHTML=uu,this}toggle(){this.playing?
this.pause():this.play()}step(t){if(this.pause(),!this.film.count)return;let e=this.film.indexAt(this.t),n=this.t>this.film.t[e];this.seek(this.film.t[wn(t<0&&n?e:e+t,0,this.film.count-1)])}jump(t){let e=this.list.from(this.t,t,1e-9*(this.end-this.begin));e&&this.pause().seek(e.t)}faster(t){let e=kt("speed");e.selectedIndex=wn(e.selectedIndex+t,0,Zo.length-1)}draw(){this.queued||(this.queued=!0,requestAnimationFrame(
()=>{this.queued=!1,this.drawNow()}))}drawNow(){this.stage.draw(this.t),this.comparison.draw(this.t),this.tab==="plots"&&this.plots.draw(this.t),this.tab==="energy"&&this.energy.draw(this.t),this.tab==="events"&&this.list.show(this.t);let t=kt("scrub");t.value=String(this.end>this.begin?(this.t-this.begin)/(this.end-this.begin):0);let e=wn(4-Math.floor(Math.log10(this.end-this.begin||1)),0,9);t.setAttribute(
"aria-valuetext",`${this.t.toFixed(e)} s of ${this.end.toFixed(e-1)} s`),kt("clock").replaceChildren(this.t.toFixed(e),St("small",` / ${this.end.toFixed(e-1)} s`)),this.fillCard(),this.tools.show(this.t),this.showScale()}showScale(){let t=[["force",!1],["impact",!0]].map(([n,s])=>{let r=this.stage.unitsPerCm(s),o=s&&this.film.knowsSteps?"N s":"N";return r>0?`${n} 1 cm = ${He(Number(r.toPrecision(2)))}\
 ${o}`:""}).filter(n=>n).join("  \xB7  "),e=kt("legend").querySelector(".scale");e&&e.textContent!==t&&(e.textContent=t)}resize(){let t=["stage","beside","side"].map(n=>`${kt(n).clientWidth} ${kt(n).clientHeight}`).join();if(t===this.sizes)return;this.sizes=t;let e=this.comparison.resize();this.showTab(this.tab),e&&this.drawNow(),this.comparison.paintMarks(this.events)}setView(t){this.stage.setView(
t in hu?t:"iso");for(let e of kt("views").children)Ts(e,e.dataset.view===this.stage.camera.view);this.draw()}setSwitch(t,e){this.stage.show[t]=e,Ts(kt("switches").querySelector(`[data-name=${t}]`),e),kt("legend").hidden=!(this.stage.show.contacts&&(this.grows||this.film.contactCount)),this.draw()}setFollow(t){let{stage:e}=this,n=this.scene.follow??this.film.firstMoving();e.follow(t?e.selected>=0?e.
selected:n:-1,this.t),e.selected<0&&e.fit(),Ts(kt("switches").querySelector("[data-name=follow]"),e.followed>=0),this.draw()}setTheme(t){fu(t),document.documentElement.classList.toggle("dark",t),this.stage.recolour(),this.comparison.beside?.stage.recolour(),this.plots.rebuild(),this.energy.rebuild(),this.comparison.paintMarks(this.events),this.fillLegend(),this.draw()}select(t){this.stage.selected=
this.scene.frames[t]?t:-1;let e=kt("selected"),n=this.scene.frames[t];if(e.replaceChildren(),n){let s=St("button","\xD7","close");if(s.onclick=()=>this.select(-1),e.append(s,St("b",n.name)),n.place){let r=St("a",n.place);r.onclick=()=>this.showLine(n.place),e.append(r)}e.append(this.tools.buttons(t),St("table"))}this.fillCard(),this.draw()}fillCard(){let{selected:t}=this.stage,e=kt("selected");e.hidden=
t<0,!(t<0)&&Ap(e.querySelector("table"),this.scene,this.film,this.signals,t,this.t,this.comparison.other)}fillPanels(t){let{run:e,model:n}=this.data,s=this.title;kt("title").textContent=s,kt("title").title=s,document.title=`${s} \xB7 dynamY ${this.grows?"live":"replay"}`,this.grows&&(document.querySelector(".brand span").textContent="live"),this.comparison.showHead(),e&&kt("run").append(...[mu(e),
pu(e)].filter(o=>o!==null)),n.text&&kt("model").append(gp(n.text)),kt("theme").innerHTML=hp,kt("theme").onclick=()=>this.setTheme(!jt.dark),this.fillLegend(),pp(kt("help"));let r=[["live","Live",this.grows],["plots","Signals",this.signals.length>0],["energy","Energy, solver",t||this.grows],["events","Events",this.events.length>0||this.grows],["run","Run",e!==null],["model","Model",n.text!==""]];for(let[
o,a,l]of r)l&&this.addTab(o,a);kt("wait").hidden=!0}addTab(t,e){let n=St("button",e);n.id=`tab_${t}`,n.dataset.tab=t,n.setAttribute("role","tab"),n.setAttribute("aria-controls",t),n.onclick=()=>this.showTab(t),kt("tabs").append(n),kt(t).setAttribute("role","tabpanel"),kt(t).setAttribute("aria-labelledby",n.id),this.tab||(this.tab=t)}fillLegend(){let t=this.events.some(e=>e.to==="spin");kt("legend").
replaceChildren(...En.slice(1,t?5:4).map(e=>{let n=St("span"),s=St("i");return s.style.background=jt.dark?Ye(e.colour,.2):e.colour,n.append(s,e.name),n}),St("span","","scale")),kt("legend").lastElementChild.title="of arrows in the plane through the middle of the picture; the arrow of an impact is its percussion in the step"}showTab(t){if(kt("tabs").querySelector(`[data-tab=${t||"none"}]`)){this.tab=
t;for(let e of kt("tabs").children)e.classList.toggle("on",e.dataset.tab===t),e.setAttribute("aria-selected",String(e.dataset.tab===t)),e.tabIndex=e.dataset.tab===t?0:-1;for(let e of["live","plots","energy","events","run","model"])kt(e).hidden=e!==t;t==="plots"&&this.plots.resize(),t==="energy"&&this.energy.resize(),t==="events"&&this.list.show(this.t,!0),this.draw()}}showLine(t){this.showTab("mod\
el");let e=kt("model").querySelectorAll("code");e.forEach(s=>s.classList.remove("here"));let n=e[Number((t.match(/:(\d+)/)??[])[1])-1];n&&(n.classList.add("here"),n.scrollIntoView({block:"center"}))}addTransport(){let t=this.grows?Number(document.body.dataset.until):this.end-this.begin,e=t>120?t/60:t<4?t/4:1,n=Zo.filter(s=>s<=Math.max(e,Zo[0])*1.05).pop();kt("speed").replaceChildren(...Zo.map(s=>{
let r=St("option",s<1?`1/${Math.round(1/s)}`:`\xD7${s}`);return r.value=String(s),r.selected=s===n,r})),kt("play").innerHTML=uu,kt("play").onclick=()=>this.toggle(),kt("back").onclick=()=>this.step(-1),kt("step").onclick=()=>this.step(1),kt("before").onclick=()=>this.jump(-1),kt("after").onclick=()=>this.jump(1);for(let s of["before","after"])kt(s).disabled=!this.events.length;kt("scrub").oninput=
s=>this.pause().seek(this.begin+Number(s.target.value)*(this.end-this.begin)),kt("link").onclick=()=>wp(this),kt("png").onclick=()=>this.savePicture(),kt("film").onclick=()=>this.saveFilm(),kt("ask").onclick=()=>this.help(),kt("tabs").onkeydown=s=>{let r=[...kt("tabs").children],o=r.findIndex(l=>l.dataset.tab===this.tab),a=s.key==="ArrowRight"?o+1:s.key==="ArrowLeft"?o-1:-1;r[a]&&(s.stopPropagation(),
r[a].click(),r[a].focus())}}help(){let t=kt("help");t.open?t.close():t.showModal()}savePicture(){let t=St("a");t.href=this.comparison.picture(this.t).toDataURL("image/png"),t.download=`${this.data.title}_${this.t.toFixed(3)}s.png`,t.click()}saveFilm(){this.pause(),Gg(this,Number(kt("speed").value),kt("film"))}addTools(){let t=(o,a,l,c)=>{let u=St("button",a);return u.title=l,u.onclick=c,kt(o).append(
u),u};for(let o of["xz","xy","yz","iso"])t("views",hu[o],"view",()=>this.setView(o)).dataset.view=o;t("views","fit","show everything (0)",()=>{this.stage.fit(),this.draw()});for(let o of this.grows||this.film.contactCount?["contacts","trails"]:["trails"])t("switches",o,o==="contacts"?"contact forces (c)":"paths of the bodies (t)",()=>this.setSwitch(o,!this.stage.show[o])).dataset.name=o;let e=t("s\
witches","names","names of the bodies (b)",()=>this.tools.nameAll());this.tools.onNames=o=>Ts(e,o);let n=t("switches","measure","distance of two points (m)",()=>this.pressed("m",this.tools.toggleMeasure())),s=t("switches","compare","lay another run over this one: its replay.html (o)",()=>{this.tools.other?this.layOver(null):this.tools.askForOther(o=>this.layOver(o),o=>alert(o))}),r=t("switches","b\
eside","the other run beside this one, or laid over it (w)",()=>this.setBeside(!this.comparison.isBeside));r.hidden=!0,this.named={b:e,m:n,o:s,w:r},t("switches","follow","the camera goes with what is selected (f)",()=>this.setFollow(this.stage.followed<0)).dataset.name="follow",Ts(kt("switches").querySelector("[data-name=follow]"),this.stage.followed>=0);for(let o of["contacts","trails"])this.setSwitch(
o,this.stage.show[o])}layOver(t){let e=Td(this.signals);this.tools.other=t,this.comparison.show(t),this.end=Math.max(Ss(this.film,this.signals)[1],t?.end??-1/0),this.plots.setPanels(t?t.addTo(e,this.data.title):e,this.begin,this.end),this.energy.setPanels(this.comparison.ledger(this.ledger),this.begin,this.end);let n=this.comparison.events(this.events);this.list.take(n),n.length&&!document.getElementById(
"tab_events")&&this.addTab("events","Events");for(let s of["before","after"])kt(s).disabled=!n.length;this.comparison.showHead(),this.comparison.paintMarks(this.events),this.pressed("o",t!==null),this.named.w.hidden=!t,this.pressed("w",this.comparison.isBeside),this.seek(this.t)}setBeside(t){this.comparison.setApart(t),this.pressed("w",this.comparison.isBeside),this.resize(),this.draw()}pressed(t,e){
Ts(this.named[t],e)}key(t){let e=t.target;if(t.ctrlKey||t.altKey||t.metaKey||["SELECT","INPUT"].includes(e.tagName)&&e.id!=="scrub")return;let n=(this.end-this.begin)/10,s=a=>{t.shiftKey?this.pause().seek(this.t+a*n):this.step(a)},r=a=>{this.stage.forceFactor*=a,this.draw()},o={" ":()=>{this.live?.goes?this.live.toggle():this.toggle()},ArrowLeft:()=>s(-1),ArrowRight:()=>s(1),Home:()=>this.pause().
seek(this.begin),End:()=>{this.live?.goes?this.live.toEdge():this.pause().seek(this.end)},n:()=>this.jump(1),p:()=>this.jump(-1),"+":()=>this.faster(1),"-":()=>this.faster(-1),1:()=>this.setView("xz"),2:()=>this.setView("xy"),3:()=>this.setView("yz"),4:()=>this.setView("iso"),0:()=>{this.stage.fit(),this.draw()},c:()=>this.setSwitch("contacts",!this.stage.show.contacts),t:()=>this.setSwitch("trail\
s",!this.stage.show.trails),f:()=>this.setFollow(this.stage.followed<0),l:()=>kt("loop").click(),s:()=>this.savePicture(),v:()=>this.saveFilm(),b:()=>this.named.b.click(),m:()=>this.named.m.click(),o:()=>this.named.o.click(),w:()=>this.named.w.click(),h:()=>this.tools.hide(this.stage.selected),H:()=>this.tools.showAll(),d:()=>this.setTheme(!jt.dark),"[":()=>r(.8),"]":()=>r(1.25),"?":()=>this.help(),
Escape:()=>{kt("help").close(),this.select(-1)}};o[t.key]&&(t.preventDefault(),o[t.key]())}};var bv=i=>document.getElementById(i);async function rE(){let i=JSON.parse(bv("data").textContent??""),t=new URLSearchParams(location.hash.slice(1)),[e,n]=await Promise.all([el(i),nl(i)]),s=document.body.dataset.live?await oE(i,e,n,t):new Xa(i,e,await Or.from(i.frames),n,await il(i),await sl(i),t),r=document.getElementById("other");r&&(s.layOver(await Hr.from(JSON.parse(r.textContent??""),"")),r.dataset.
beside&&s.setBeside(!0)),document.body.classList.remove("reading"),Object.assign(window,{replay:s})}async function oE(i,t,e,n){let s=new ul(t.frames.length,e);do await s.ask();while(!s.film.count);let r=new Xa(i,t,s.film,e,s.events,s.ledgerColumns(),n,!0);return r.live=r.stage.hand=new fl(r,s),r}rE().catch(i=>{throw document.body.classList.remove("reading"),bv("wait").textContent=`This page cannot\
 be shown: ${i instanceof Error?i.message:i}`,i});})();
