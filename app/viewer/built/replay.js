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
"use strict";(()=>{function nd(i){let{camera:t}=i.stage,e=new URLSearchParams;e.set("t",String(Number(i.t.toPrecision(9)))),e.set("view",t.view),t.isPlanar||(e.set("azimuth",String(Math.round(t.azimuth*180/Math.PI))),e.set("elevation",String(Math.round(t.elevation*180/Math.PI)))),history.replaceState(null,"",`#${e}`),navigator.clipboard?.writeText(location.href).catch(()=>{})}function Th(i,t){let{camera:e}=i.stage;for(let r of[
"azimuth","elevation"])t.has(r)&&(e[r]=Number(t.get(r))*Math.PI/180);t.has("view")?i.setView(t.get("view")??""):(t.has("azimuth")||t.has("elevation"))&&(e.look(),i.stage.fit());for(let r of["contacts","trails"])t.has(r)&&i.setSwitch(r,t.get(r)!=="0");t.has("theme")&&i.setTheme(t.get("theme")==="dark");let n=t.get("open");n&&i.showTab(n);let s=Number(t.get("t"));i.pause().seek(t.has("t")&&Number.isFinite(
s)?s:i.t),t.has("select")&&i.select(Number(t.get("select"))),t.get("play")==="1"&&i.play()}var ci=Uint8Array,wr=Uint16Array,Y0=Int32Array,id=new ci([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),sd=new ci([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),$0=new ci([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),rd=function(i,t){for(var e=new wr(31),n=0;n<31;++n)e[n]=t+=1<<i[n-1];for(var s=new Y0(e[30]),n=1;n<30;++n)for(var r=e[n];r<e[n+1];++r)
s[r]=r-e[n]<<5|n;return{b:e,r:s}},od=rd(id,2),ad=od.b,Z0=od.r;ad[28]=258,Z0[258]=28;var ld=rd(sd,0),J0=ld.b,Z1=ld.r,Rh=new wr(32768);for(Ae=0;Ae<32768;++Ae)Ji=(Ae&43690)>>1|(Ae&21845)<<1,Ji=(Ji&52428)>>2|(Ji&13107)<<2,Ji=(Ji&61680)>>4|(Ji&3855)<<4,Rh[Ae]=((Ji&65280)>>8|(Ji&255)<<8)>>1;var Ji,Ae,Lo=(function(i,t,e){for(var n=i.length,s=0,r=new wr(t);s<n;++s)i[s]&&++r[i[s]-1];var o=new wr(t);for(s=1;s<
t;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(e){a=new wr(1<<t);var c=15-t;for(s=0;s<n;++s)if(i[s])for(var l=s<<4|i[s],h=t-i[s],u=o[i[s]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)a[Rh[u]>>c]=l}else for(a=new wr(n),s=0;s<n;++s)i[s]&&(a[s]=Rh[o[i[s]-1]++]>>15-i[s]);return a}),Do=new ci(288);for(Ae=0;Ae<144;++Ae)Do[Ae]=8;var Ae;for(Ae=144;Ae<256;++Ae)Do[Ae]=9;var Ae;for(Ae=256;Ae<280;++Ae)Do[Ae]=7;var Ae;for(Ae=280;Ae<288;++Ae)
Do[Ae]=8;var Ae,cd=new ci(32);for(Ae=0;Ae<32;++Ae)cd[Ae]=5;var Ae;var K0=Lo(Do,9,1);var j0=Lo(cd,5,1),Ah=function(i){for(var t=i[0],e=1;e<i.length;++e)i[e]>t&&(t=i[e]);return t},yi=function(i,t,e){var n=t/8|0;return(i[n]|i[n+1]<<8)>>(t&7)&e},Ch=function(i,t){var e=t/8|0;return(i[e]|i[e+1]<<8|i[e+2]<<16)>>(t&7)},Q0=function(i){return(i+7)/8|0},tv=function(i,t,e){return(t==null||t<0)&&(t=0),(e==null||e>i.length)&&(e=i.length),new ci(i.subarray(t,e))};var ev=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Mi=function(i,t,e){var n=new Error(t||ev[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Mi),!e)throw n;return n},
nv=function(i,t,e,n){var s=i.length,r=n?n.length:0;if(!s||t.f&&!t.l)return e||new ci(0);var o=!e,a=o||t.i!=2,c=t.i;o&&(e=new ci(s*3));var l=function(Qt){var Pe=e.length;if(Qt>Pe){var U=new ci(Math.max(Pe*2,Qt));U.set(e),e=U}},h=t.f||0,u=t.p||0,f=t.b||0,d=t.l,g=t.d,_=t.m,m=t.n,p=s*8;do{if(!d){h=yi(i,u,1);var b=yi(i,u+1,3);if(u+=3,b)if(b==1)d=K0,g=j0,_=9,m=5;else if(b==2){var A=yi(i,u,31)+257,D=yi(i,
u+10,15)+4,N=A+yi(i,u+5,31)+1;u+=14;for(var w=new ci(N),S=new ci(19),C=0;C<D;++C)S[$0[C]]=yi(i,u+C*3,7);u+=D*3;for(var O=Ah(S),z=(1<<O)-1,G=Lo(S,O,1),C=0;C<N;){var X=G[yi(i,u,z)];u+=X&15;var T=X>>4;if(T<16)w[C++]=T;else{var q=0,Z=0;for(T==16?(Z=3+yi(i,u,3),u+=2,q=w[C-1]):T==17?(Z=3+yi(i,u,7),u+=3):T==18&&(Z=11+yi(i,u,127),u+=7);Z--;)w[C++]=q}}var j=w.subarray(0,A),rt=w.subarray(A);_=Ah(j),m=Ah(rt),
d=Lo(j,_,1),g=Lo(rt,m,1)}else Mi(1);else{var T=Q0(u)+4,y=i[T-4]|i[T-3]<<8,I=T+y;if(I>s){c&&Mi(0);break}a&&l(f+y),e.set(i.subarray(T,I),f),t.b=f+=y,t.p=u=I*8,t.f=h;continue}if(u>p){c&&Mi(0);break}}a&&l(f+131072);for(var ot=(1<<_)-1,vt=(1<<m)-1,xt=u;;xt=u){var q=d[Ch(i,u)&ot],pt=q>>4;if(u+=q&15,u>p){c&&Mi(0);break}if(q||Mi(2),pt<256)e[f++]=pt;else if(pt==256){xt=u,d=null;break}else{var ee=pt-254;if(pt>
264){var C=pt-257,Zt=id[C];ee=yi(i,u,(1<<Zt)-1)+ad[C],u+=Zt}var Q=g[Ch(i,u)&vt],tt=Q>>4;Q||Mi(3),u+=Q&15;var rt=J0[tt];if(tt>3){var Zt=sd[tt];rt+=Ch(i,u)&(1<<Zt)-1,u+=Zt}if(u>p){c&&Mi(0);break}a&&l(f+131072);var Mt=f+ee;if(f<rt){var Ot=r-rt,_t=Math.min(rt,Mt);for(Ot+f<0&&Mi(3);f<_t;++f)e[f]=n[Ot+f]}for(;f<Mt;++f)e[f]=e[f-rt]}}t.l=d,t.p=xt,t.b=f,t.f=h,d&&(h=1,t.m=_,t.d=g,t.n=m)}while(!h);return f!=
e.length&&o?tv(e,0,f):e.subarray(0,f)};var iv=new ci(0);var sv=function(i,t){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Mi(6,"invalid zlib data"),(i[1]>>5&1)==+!t&&Mi(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function hd(i,t){return nv(i.subarray(sv(i,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var rv=typeof TextDecoder<"u"&&new TextDecoder,ov=0;try{rv.decode(iv,{stream:!0}),ov=1}catch{}var Rt=(i,t)=>[i[0]+t[0],i[1]+t[1],i[2]+t[2]],ue=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],Tt=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],Ht=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],Ze=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],Tn=i=>Math.hypot(i[0],i[1],i[2]),On=i=>Tt(i,1/(Tn(i)||1)),Fa=i=>On(Ze(Math.abs(i[0])<.9?[1,0,0]:[0,1,0],i));function av(i,t){return[i[0]*t[0]-i[1]*t[1]-i[2]*t[2]-i[3]*
t[3],i[0]*t[1]+i[1]*t[0]+i[2]*t[3]-i[3]*t[2],i[0]*t[2]-i[1]*t[3]+i[2]*t[0]+i[3]*t[1],i[0]*t[3]+i[1]*t[2]-i[2]*t[1]+i[3]*t[0]]}function vn(i,t){let e=[i[1],i[2],i[3]],n=Tt(Ze(e,t),2);return Rt(Rt(t,Tt(n,i[0])),Ze(e,n))}function fd(i,t,e){return{r:Rt(i.r,vn(i.q,t)),q:av(i.q,e)}}function Gn(i,t,e){return Math.min(e,Math.max(t,i))}function Er(i,t){let e=0,n=i.length-1;for(;e<n;){let s=e+n+1>>1;i[s]<=t?
e=s:n=s-1}return e}function Vs(i,t,e){let n=t-i;if(!(n>0)||!Number.isFinite(n))return{step:1,values:[i]};let s=10**Math.floor(Math.log10(n/e));for(let r of[1,2,5,10,20]){let o=r*s,a=Math.ceil(i/o-1e-9),c=Math.floor(t/o+1e-9);if(c-a+1>e)continue;let l=[];for(let h=a;h<=c;++h)l.push(h*o+0);return{step:o,values:l}}return{step:n,values:[i]}}var ud="\u2212";function Bn(i){if(!Number.isFinite(i))return Number.isNaN(i)?"\u2013":String(i);let t=Math.abs(i);return t!==0&&(t>=1e5||t<1e-4)?Number(i.toPrecision(4)).toExponential().replace("e+","e").replace(/-/g,ud):String(Number(i.toPrecision(4))).replace("-",ud)}function dd(i){let[t,e]=i<.0095?[1e3,"mm"]:i<.95?[100,"cm"]:i<950?[1,"m"]:[.001,"km"];return`${Number((i*t).toPrecision(4))} ${e}`}async function xs(i){if(!i)return new Uint8Array(0);let t=atob(i),e=new Uint8Array(t.length);for(let s=0;s<t.length;++s)e[s]=t.charCodeAt(s);if(typeof DecompressionStream>"u")return hd(e);let n=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(n).arrayBuffer())}var Ph=i=>new DataView(i.buffer,i.byteOffset,i.byteLength);async function gd(i){
let t=Ph(await xs(i));return Float64Array.from({length:t.byteLength/8},(e,n)=>t.getFloat64(8*n,!0))}async function vd(i){let t=Ph(await xs(i));return Float32Array.from({length:t.byteLength/4},(e,n)=>t.getFloat32(4*n,!0))}function pd(i,t,e,n){let s=new Uint16Array(t*e),r=t*e;for(let o=0;o<t;++o){let a=0,c=0,l=n[o];for(let h=0,u=o*e;h<e;++h,++u){let f=i[u]|i[r+u]<<8,d=f>>1^-(f&1);h===1&&(c=a);let g=d+
(l===0?0:l===1?a:2*a-c)&65535;s[h*t+o]=g,c=a,a=g}}return s}var Tr=12,lv=-32768,md=(i,t)=>i===lv?0:2**(i/t),Na=class i{constructor(t,e,n,s,r,o,a,c){this.poses=t;this.t=e;this.lo=n;this.course=r;this.contact=a;this.coding=c;this.count=e.length,this.now=new Float32Array(7*t),this.varying=new Int32Array(7*t).fill(-1),this.step=new Float32Array(7*t),this.columns=0;for(let l=0;l<7*t;++l)n[l]<s[l]&&(this.
varying[l]=this.columns++,this.step[l]=(s[l]-n[l])/(l%7<3?c.placeSteps:c.turnSteps));this.firstContact=new Uint32Array(o.length+1);for(let l=0;l<o.length;++l)this.firstContact[l+1]=this.firstContact[l]+o[l]}static async from(t){let[e,n,s,r,o,a]=await Promise.all([gd(t.t),vd(t.ranges),xs(t.orders),xs(t.data),xs(t.contacts.counts),xs(t.contacts.data)]),c=d=>n.filter((g,_)=>_%2===d),l=pd(r,s.length,e.
length,s),h=Ph(o),u=Uint32Array.from({length:h.byteLength/4},(d,g)=>h.getUint32(4*g,!0)),f=pd(a,Tr,a.length/2/Tr,new Uint8Array(Tr));return new i(t.poses,e,c(0),c(1),l,u,new Int16Array(f.buffer),t)}get begin(){return this.count?this.t[0]:0}get end(){return this.count?this.t[this.count-1]:0}get contactCount(){return this.contact.length/Tr}indexAt(t){return Er(this.t,t)}place(t){let e=this.indexAt(t),
n=Math.min(e+1,this.count-1),s=n>e?Gn((t-this.t[e])/(this.t[n]-this.t[e]),0,1):0;return[e*this.columns,n*this.columns,s]}sample(t){if(!this.count)return this.now;let[e,n,s]=this.place(t),{now:r,varying:o,lo:a,step:c,course:l}=this;for(let h=0;h<r.length;++h){let u=o[h];r[h]=u<0?a[h]:a[h]+c[h]*(l[e+u]+(l[n+u]-l[e+u])*s)}for(let h=3;h<r.length;h+=7){let u=Math.sqrt(r[h]**2+r[h+1]**2+r[h+2]**2+r[h+3]**
2)||1;for(let f=h;f<h+4;++f)r[f]/=u}return r}pose(t,e){if(t<0||!this.count)return{r:[0,0,0],q:[1,0,0,0]};let[n,s,r]=this.place(e),o=l=>{let h=this.varying[7*t+l],u=this.lo[7*t+l];return h<0?u:u+this.step[7*t+l]*(this.course[n+h]+(this.course[s+h]-this.course[n+h])*r)},a=[o(3),o(4),o(5),o(6)],c=Math.hypot(...a)||1;return{r:[o(0),o(1),o(2)],q:a.map(l=>l/c)}}rates(t,e){let n=Math.min(this.indexAt(e),
Math.max(0,this.count-2)),s=Math.min(n+1,this.count-1),r=this.t[s]-this.t[n];if(!(r>0))return{v:[0,0,0],omega:[0,0,0]};let o=this.pose(t,this.t[n]),a=this.pose(t,this.t[s]),[c,l,h,u]=o.q,f=a.q,d=[f[0]*c+f[1]*l+f[2]*h+f[3]*u,f[1]*c-f[0]*l-f[2]*u+f[3]*h,f[2]*c-f[0]*h-f[3]*l+f[1]*u,f[3]*c-f[0]*u-f[1]*h+f[2]*l],g=Math.hypot(d[1],d[2],d[3]),_=2*Math.atan2(g,d[0]),m=g>1e-12?_/g/r:2/r;return{v:[0,1,2].map(
p=>(a.r[p]-o.r[p])/r),omega:[d[1],d[2],d[3]].map(p=>p*m)}}moves(t){return t>=0&&[0,1,2,3,4,5,6].some(e=>this.varying[7*t+e]>=0)}stands(t,e,n){let s=7*t+e;return this.varying[s]<0&&(n===void 0||Math.abs(this.lo[s]-n)<1e-6)}firstMoving(){for(let t=0;t<this.poses;++t)if(this.moves(t))return t;return-1}contacts(t){let e=[];if(!this.count)return e;let n=this.indexAt(t);for(let s=this.firstContact[n];s<
this.firstContact[n+1];++s)e.push(this.contactAt(s));return e}contactAt(t){let e=this.contact.subarray(Tr*t,Tr*(t+1)),{box:n,placeSteps:s,octaveSteps:r}=this.coding.contacts,o=u=>n[2*u]+(n[2*u+1]-n[2*u])*(e[u]&65535)/s,a=On([e[3],e[4],e[5]]),c=On([e[3]+e[7],e[4]+e[8],e[5]+e[9]]),l=md(e[6],r),h=md(e[11],r)*(l||1);return{r:[o(0),o(1),o(2)],n:a,F:Tt(c,l),state:e[10],limit:h}}usualForce(){let t=[],e=this.
contactCount,n=Math.max(1,Math.floor(e/5e3));for(let s=0;s<e;s+=n){let r=this.contactAt(s),o=Math.hypot(...r.F);o>0&&Number.isFinite(o)&&r.state!==3&&t.push(o)}if(!t.length)for(let s=0;s<e;s+=n)t.push(Math.hypot(...this.contactAt(s).F));return t.sort((s,r)=>s-r),t.length?t[Math.floor(.9*(t.length-1))]:0}};async function _d(i){return JSON.parse(new TextDecoder().decode(await xs(i.scene)))}async function xd(i){
let t=new Map,e=i.run&&Array.isArray(i.run.signals)?i.run.signals:[];for(let o of e)t.set(o.name,o.unit);let n=await Promise.all(i.signals.map(o=>o.t===void 0?null:gd(o.t))),s=await Promise.all(i.signals.map(o=>vd(o.y))),r=new Float64Array(0);return i.signals.map((o,a)=>(r=n[a]??r,{name:o.name,unit:o.unit||t.get(o.name)||"",t:r,y:s[a]}))}async function yd(i){return new TextDecoder().decode(await xs(
i)).split(`
`).filter(e=>e).map(e=>(e.includes('"')?e.match(/("([^"]|"")*"|[^,]*)(,|$)/g)??[]:e.split(",")).map(n=>n.replace(/,$/,"").replace(/^"(.*)"$/,"$1").replace(/""/g,'"')))}async function Md(i){let t=await yd(i.events),e=i.run?.settings;return cv(t.slice(1).filter(n=>n.length>=7).map(n=>({t:Number(n[0]),impact:n[1]==="impact",system:n[1]==="impact"||n[1]==="switch"?"":n[1],contact:n[2],from:n[3],to:n[4],
speed:Number(n[5]),impulse:Number(n[6])})),1.5*(e?.step??0))}function cv(i,t){let e=new Map,n=new Set;for(let s of i){let r=e.get(s.contact);r&&!s.system&&!s.impact&&!r.impact&&!n.has(r)&&s.t-r.t<=t&&r.from===s.to&&r.to===s.from&&n.add(r).add(s),e.set(s.contact,s)}return n.size?i.filter(s=>!n.has(s)):i}async function bd(i){let t=await yd(i.ledger),e=new Map;if(t.length<2)return e;let n=t.slice(1).
filter(s=>s.length===t[0].length);return t[0].forEach((s,r)=>e.set(s,Float64Array.from(n,o=>Number(o[r])))),e}var Ih=class{constructor(){this.data=new Uint8Array(65536);this.length=0}room(t){if(this.length+t<=this.data.length)return;let e=new Uint8Array(Math.max(2*this.data.length,this.length+t));e.set(this.data),this.data=e}add(...t){this.put(t)}put(t){this.room(t.length),this.data.set(t,this.length),this.length+=t.length}word(t){this.add(t&255,t>>8&255)}text(t){this.put([...t].map(e=>e.charCodeAt(0)))}done(){
return this.data.slice(0,this.length)}},Sd=(i,t,e)=>i>>3<<10|t>>3<<5|e>>3,Oa=class{constructor(){this.count=new Float64Array(32768);this.sum=[0,1,2].map(()=>new Float64Array(32768));this.colours=[];this.nearest=new Int16Array(32768).fill(-1)}look(t){for(let e=0;e<t.length;e+=4){let n=Sd(t[e],t[e+1],t[e+2]);++this.count[n];for(let s=0;s<3;++s)this.sum[s][n]+=t[e+s]}}close(){let t=[];for(let a=0;a<32768;++a)
this.count[a]&&t.push(a);let e=(a,c)=>this.sum[c][a]/this.count[a],n=a=>Math.sqrt(this.count[a]),s=a=>{let c=0,l=0;for(let h=0;h<3;++h){let u=256,f=-1;for(let d of a)u=Math.min(u,e(d,h)),f=Math.max(f,e(d,h));f-u>c&&(c=f-u,l=h)}return[c,l]},r=a=>{let[c,l]=s(a);return{group:a,channel:l,size:c*Math.sqrt(a.reduce((h,u)=>h+n(u),0))}},o=[r(t)];for(;o.length<255;){let a=0;o.forEach((d,g)=>{d.size>o[a].size&&
(a=g)});let{group:c,channel:l,size:h}=o[a];if(!(h>0))break;c.sort((d,g)=>e(d,l)-e(g,l));let u=c.reduce((d,g)=>d+n(g),0)/2,f=1;for(let d=n(c[0]);f<c.length-1&&d<u;++f)d+=n(c[f]);o.splice(a,1,r(c.slice(0,f)),r(c.slice(f)))}for(let{group:a}of o){let c=a.reduce((l,h)=>l+this.count[h],0)||1;this.colours.push([0,1,2].map(l=>Math.round(a.reduce((h,u)=>h+this.sum[l][u],0)/c)))}}indexOf(t,e,n){let s=Sd(t,e,
n);if(this.nearest[s]>=0)return this.nearest[s];let r=0,o=1/0;return this.colours.forEach(([a,c,l],h)=>{let u=2*(a-t)**2+4*(c-e)**2+(l-n)**2;u<o&&(o=u,r=h)}),this.nearest[s]=r}};function hv(i,t){t.add(8);let s=[],r=0,o=0,a=9,c=258,l=new Map,h=()=>{s.length&&(t.add(s.length),t.put(s),s=[])},u=d=>{for(o|=d<<r,r+=a;r>=8;)s.push(o&255),o>>>=8,r-=8,s.length===255&&h()};u(256);let f=i[0];for(let d=1;d<i.
length;++d){let g=f<<8|i[d],_=l.get(g);if(_!==void 0){f=_;continue}u(f),c===4096?(u(256),l=new Map,c=258,a=9):(c===1<<a&&++a,l.set(g,c++)),f=i[d]}u(f),u(257),r&&s.push(o&255),h(),t.add(0)}var Ba=class{constructor(t,e,n){this.width=t;this.height=e;this.table=n;this.out=new Ih;this.before=null;this.written=0;let{out:s}=this;s.text("GIF89a"),s.word(t),s.word(e),s.add(247,0,0);for(let r=0;r<256;++r)s.
put(n.colours[r]??[0,0,0]);s.add(33,255,11),s.text("NETSCAPE2.0"),s.add(3,1,0,0,0)}add(t,e){let{out:n,width:s,height:r,table:o,before:a}=this,c=new Uint8Array(s*r);for(let m=0;m<c.length;++m)c[m]=o.indexOf(t[4*m],t[4*m+1],t[4*m+2]);let l=0,h=0,u=s-1,f=r-1;if(a){l=s,h=r,u=f=-1;for(let m=0,p=0;m<r;++m)for(let b=0;b<s;++b,++p)c[p]!==a[p]&&(l=Math.min(l,b),u=Math.max(u,b),h=Math.min(h,m),f=m);u<0&&(l=
h=u=f=0)}let d=new Uint8Array((u-l+1)*(f-h+1));for(let m=h,p=0;m<=f;++m)for(let b=l;b<=u;++b,++p){let T=m*s+b;d[p]=a&&a[T]===c[T]?255:c[T]}let g=Math.round(100*e),_=Math.max(2,g-this.written);this.written+=_,n.add(33,249,4,a?5:4),n.word(_),n.add(255,0,44);for(let m of[l,h,u-l+1,f-h+1])n.word(m);n.add(0),hv(d,n),this.before=c}done(){return this.out.add(59),this.out.done()}};var wd={dark:!1,paper:"#ffffff",grid:"#eff1f4",gridZero:"#dde2e8",ink:"#1f2933",soft:"#5f6c7b",ground:"#f3f4f6",groundLine:"#d5dae0",hatch:"#9aa5b1",edge:"#3e4c59",accent:"#1769aa",sheet:"rgba(140, 150, 162, .10)",still:"#a9b2bd"},uv={dark:!0,paper:"#15191e",grid:"#1e242b",gridZero:"#303943",ink:"#e6eaee",soft:"#9aa7b4",ground:"#1c2229",groundLine:"#333d48",hatch:"#566270",edge:"#9aa7b4",accent:"#\
5aa9e6",sheet:"rgba(140, 150, 162, .14)",still:"#7f8b98"},se=wd;function Lh(i){se=i?uv:wd}var Uo=["#3b82b8","#d9803b","#5a9e63","#a066b0","#c9a53a","#c75b62","#4aa3a2","#7d8794"],Ar=["#2b7bba","#d2601a","#3a9150","#9258b5","#b78a1c","#c2485c","#3a9d9c","#77828f"],bn=[{name:"open",colour:"#8a94a0"},{name:"stick",colour:"#1f9d57"},{name:"slip",colour:"#e0701a"},{name:"impact",colour:"#d81b72"},{name:"\
spin",colour:"#8e5bd0"}];function Je(i,t){let e=t>0?255:0,n=Math.abs(t),s=r=>{let o=parseInt(i.slice(r,r+2),16);return Math.round(o+(e-o)*n).toString(16).padStart(2,"0")};return"#"+s(1)+s(3)+s(5)}function Cr(i){if(i.colour&&/^#[0-9a-f]{6}$/i.test(i.colour))return i.colour;if(i.colour){let t=document.createElement("canvas").getContext("2d");if(t){t.fillStyle="#010203",t.fillStyle=i.colour;let e=String(
t.fillStyle);if(e.startsWith("#")&&e!=="#010203")return e}}return i.frame<0?se.still:Uo[i.frame%Uo.length]}var Ed=i=>{let t=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),e=0;for(let n of i)t.set(n,e),e+=n.length;return t};function bi(i,...t){let e=t.reduce((s,r)=>s+r.length,0),n=[];for(let s=24;s>=0;s-=8)i>>>s&&n.push(i>>>s&255);return n.push(1,0,0,Math.floor(e/2**32),e>>>24&255,e>>>16&255,e>>>8&255,e&255),Ed([n,...t])}var jn=(i,t)=>bi(i,[t>>>24&255,t>>>16&255,t>>>8&255,t&255]),ka=(i,t)=>bi(i,[...t].map(
e=>e.charCodeAt(0)));function fv(i,t){let e=new Uint8Array(8);return new DataView(e.buffer).setFloat64(0,t),bi(i,e)}function dv(i,t,e,n,s){let r=[],o=0,a=[],c=()=>{a.length&&r.push(bi(524531317,jn(231,o),...a)),a=[]};for(let l of i){(l.key||l.time-o>3e4)&&(c(),o=l.time);let h=l.time-o;a.push(bi(163,[129,h>>8&255,h&255,l.key?128:0],l.data))}return c(),Ed([bi(440786851,jn(17030,1),jn(17143,1),jn(17138,
4),jn(17139,8),ka(17026,"webm"),jn(17031,4),jn(17029,2)),bi(408125543,bi(357149030,jn(2807729,1e6),ka(19840,"dynamY"),ka(22337,"dynamY"),fv(17545,s)),bi(374648427,bi(174,jn(215,1),jn(29637,1),jn(131,1),ka(134,t),bi(224,jn(176,e),jn(186,n)))),...r)])}var Dh=()=>typeof VideoEncoder<"u";async function Td(i,t,e,n,s){let r=[],o=null,a=new VideoEncoder({output:h=>{let u=new Uint8Array(h.byteLength);h.copyTo(
u),r.push({time:Math.round(h.timestamp/1e3),key:h.type==="key",data:u})},error:h=>{o=h}}),c="V_VP9",l={codec:"vp09.00.41.08",width:e,height:n,framerate:t,latencyMode:"quality",bitrate:Math.max(4e5,.12*e*n*t)};(await VideoEncoder.isConfigSupported(l)).supported||(l.codec="vp8",c="V_VP8"),a.configure(l);for(let h=0;h<i;++h){let u=new VideoFrame(await s(h),{timestamp:Math.round(1e6*h/t),duration:Math.
round(1e6/t)});for(a.encode(u,{keyFrame:h%Math.max(1,Math.round(2*t))===0}),u.close();a.encodeQueueSize>8;)await new Promise(f=>setTimeout(f,5));if(o)throw o}return await a.flush(),a.close(),dv(r,c,e,n,1e3*i/t)}var pv="system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",za=class{constructor(t,e){this.replay=t;this.choice=e;this.count=Math.max(1,Math.round((e.to-e.from)*e.slower*e.fps));let{canvas:n}=t.stage.overlay,s=r=>Math.max(2,2*Math.round(r/2));this.picture=document.createElement("canvas"),this.picture.width=s(e.width??n.width),this.picture.height=s(e.height??n.height),this.ctx=this.picture.
getContext("2d",{willReadFrequently:!0})}paint(t){let{ctx:e,picture:n,choice:s,replay:r}=this,{width:o,height:a}=n,c=Math.min(s.from+t/(s.slower*s.fps),r.end);return e.fillStyle=se.paper,e.fillRect(0,0,o,a),e.drawImage(r.stage.picture(c),0,0,o,a),this.caption(c),n}caption(t){let{ctx:e,picture:n,replay:s}=this,r=Math.max(11,Math.round(n.height/40)),o=s.end-s.begin,a=Math.max(0,Math.min(6,3-Math.floor(
Math.log10(o||1))));if(e.font=`${r}px ${pv}`,e.textBaseline="top",e.textAlign="left",e.fillStyle=se.soft,e.fillText(`${t.toFixed(a)} s`,r,r),!s.stage.show.contacts||!s.film.contactCount)return;e.textAlign="right";let c=n.width-r;for(let l of bn.slice(1,4).reverse())e.fillStyle=se.soft,e.fillText(l.name,c,r),c-=e.measureText(l.name).width+.5*r,e.fillStyle=se.dark?Je(l.colour,.2):l.colour,e.fillRect(
c-r,1.45*r,r,.22*r),c-=2*r}pixels(t){return this.paint(t),this.ctx.getImageData(0,0,this.picture.width,this.picture.height).data}async gif(t){let e=new Oa,n=Math.min(this.count,12);for(let r=0;r<n;++r)e.look(this.pixels(Math.floor(r*this.count/n)));e.close();let s=new Ba(this.picture.width,this.picture.height,e);for(let r=0;r<this.count;++r)s.add(this.pixels(r),(r+1)/this.choice.fps),await t((r+1)/
this.count);return s.done()}async webm(t){return Td(this.count,this.choice.fps,this.picture.width,this.picture.height,async e=>(await t((e+1)/this.count),this.paint(e)))}png(t){return this.paint(t).toDataURL("image/png").split(",")[1]}},mv=async i=>{let t=await new Promise(e=>{let n=new FileReader;n.onload=()=>e(String(n.result)),n.readAsDataURL(new Blob([i]))});return t.slice(t.indexOf(",")+1)},Va=class{constructor(t){
this.replay=t;this.film=null;this.share=0}begin(t){let{stage:e}=this.replay;if(t.width&&t.height){let c=document.getElementById("stage");c.style.cssText=`position:fixed;left:0;top:0;z-index:9;width:${t.width}px;height:${t.height}px`,e.resize(),e.fit()}let{begin:n,end:s}=this.replay,r=Math.max(t.from??n,n),o=Math.min(t.to??s,s),a=t.slower??Number(document.getElementById("speed").value);return this.
film=new za(this.replay,{...t,from:r,to:o,slower:a}),this.film.count}take(t){return this.film?.png(t)??""}async file(t){if(!this.film)return"";if(t==="webm"&&!Dh())throw new Error("this browser codes no films: take a GIF");let e=async n=>{this.share=n,await new Promise(s=>setTimeout(s,0))};return mv(await this.film[t](e))}};async function Ad(i,t,e){let n=e.textContent,s=async a=>{e.textContent=`${Math.
round(100*a)} %`,await new Promise(c=>setTimeout(c,0))},r=new za(i,{from:i.begin,to:i.end,slower:1/t,fps:25}),o=Dh()?"webm":"gif";try{let a=await r[o](s),c=document.createElement("a");c.href=URL.createObjectURL(new Blob([a],{type:o==="webm"?"video/webm":"image/gif"})),c.download=`${i.data.title}.${o}`,c.click()}finally{e.textContent=n,i.draw()}}var Fo=[.01,.02,.05,.1,.2,.5,1,2,5,10],Uh={xz:"x\u2013z",xy:"x\u2013y",yz:"y\u2013z",iso:"3D"},Fh='<svg viewBox="0 0 14 14"><path d="M2 0.5v13l11-6.5z"/></svg>',Cd='<svg viewBox="0 0 14 14"><path d="M2 1h3.6v12H2zM8.4 1H12v12H8.4z"/></svg>',Rd='<svg viewBox="0 0 16 16"><path d="M8 1a7 7 0 100 14A7 7 0 008 1zm0 1.5v11a5.5 5.5 0 010-11z"/></svg>',Pd=[["space","play, pause"],["\u2190 \u2192","one fra\
me back, on"],["shift \u2190 \u2192","a tenth of the film"],["n p","next, previous impact or switch"],["home end","first, last frame"],["+ \u2212","faster, slower"],["l","loop"],["1 2 3 4","view x\u2013z, x\u2013y, y\u2013z, 3D"],["0","fit"],["c t","contact forces, trails"],["[ ]","shorter, longer force arrows"],["f","follow what is selected, else the body the model names, else the first"],["s v",
"save the picture, a film"],["d","light, dark"],["drag","turn (3D) or move; with shift: move"],["wheel, two fingers","zoom"],["click","name, state and place of a body"],["in the curves","click: to this time; drag: zoom; double click: all"]];function de(i,t="",e=""){let n=document.createElement(i);return t&&(n.textContent=t),e&&(n.className=e),n}var Nh=i=>i===null?"\u2013":typeof i=="number"&&!Number.isInteger(i)?Bn(i):String(i);function Id(i){let t=de("table"),e=(n,s)=>{for(let[r,o]of Object.entries(n)){let a=Array.isArray(o)?o:null;if(a&&a.some(h=>h!==null&&typeof h=="object"))continue;let c=t.insertRow(),l=c.insertCell();l.textContent=
r.replace(/_/g," ").replace(/([a-z])([A-Z])/g,"$1 $2").toLowerCase(),l.style.paddingLeft=`${14*s}px`,o!==null&&typeof o=="object"&&!a?(l.colSpan=2,l.className="group",e(o,s+1)):c.insertCell().textContent=a?a.map(Nh).join(", "):Nh(o)}};return e(i,0),t}function Ld(i){let t=Array.isArray(i.checks)?i.checks:[];if(!t.length)return null;let e=de("table","","checks");for(let n of t){let s=e.insertRow();s.
insertCell().append(de("span",n.pass?"pass":"fail",n.pass?"good":"bad")),s.insertCell().textContent=`${n.measure==="value"?"":`${n.measure} `}${n.signal}${n.over?` ${n.over}`:""}`,s.insertCell().textContent=`${Nh(n.got)} (${String(n.expected)})`}return e}function Dd(i,t,e){let{run:n}=i,s=[],r=(...a)=>{s.push(...s.length?[" \xB7 ",...a]:a)};n&&typeof n.state=="string"&&r(["finished","ok","done"].includes(
n.state)?n.state:de("b",n.state,"bad")),r(de("b",Bn(t))," s");for(let[a,c]of[["steps","steps"],["impacts","impacts"],["switches","switches"]])n&&typeof n[a]=="number"&&r(de("b",String(n[a])),` ${c}`);n&&typeof n.wall_s=="number"&&r("computed in ",de("b",Bn(n.wall_s))," s");let{recorded:o}=i.frames;return e&&r(e<o?de("b",`${e} of ${o} frames`,"bad"):`${e} frames`),s}function Ud(i){let t=i.get("t");
if(!t)return[];let e=h=>i.get(h)??new Float64Array(t.length),n=(h,u)=>({name:h,t,y:u}),s=(h,u)=>e(h).some(f=>f!==0)?[n(u,e(h))]:[],r=e("kinetic"),o=e("potential"),a=[];a.push({title:"energy",unit:"J",height:170,curves:[n("kinetic",r),n("potential",o),n("sum",r.map((h,u)=>h+o[u]))]});let c=[...s("normal","impacts"),...s("friction","friction"),...s("nonPotential","drives, dampers"),...s("joints","jo\
ints"),...s("boundaries","moving boundaries")];c.length&&a.push({title:"work",unit:"J",height:160,curves:c}),a.push({title:"ledger",unit:"J",curves:s("discretisation","discretisation")});let l=(h,u,f,d=!1)=>{let g=s(h,u);g.length&&a.push({unit:f,curves:g,log:d,height:110})};return l("residual","solver residual","",!0),l("iterations","iterations",""),l("contacts","contacts",""),l("penetration","pen\
etration","m",!0),a.filter(h=>h.curves.length)}var Rr=26,Ha=class{constructor(t,e,n){this.box=t;this.all=e;this.seek=n;this.rows=de("div","","rows");this.kind="all";this.events=[];this.current=-1;this.t=0;let s=de("div","","bar");for(let r of["all","impacts","switches"]){let o=r==="all"?e.length:e.filter(c=>c.impact===(r==="impacts")).length,a=de("button",`${r} ${o}`,r==="all"?"on":"");a.onclick=()=>{
for(let c of s.children)c.classList.toggle("on",c===a);this.kind=r,this.filter()},s.append(a)}t.replaceChildren(s,this.rows),this.filter(),t.addEventListener("scroll",()=>this.fill())}filter(){this.events=this.kind==="all"?this.all:this.all.filter(t=>t.impact===(this.kind==="impacts")),this.rows.style.height=`${Rr*this.events.length}px`,this.current=-2,this.show(this.t,!0)}from(t,e,n){let s=this.events.
length?this.events:this.all;return e>0?s.find(r=>r.t>t+n):[...s].reverse().find(r=>r.t<t-n)}show(t,e=!1){this.t=t;let n=this.events.map.length?this.events:[],s=n.length&&n[0].t<=t?Er(n.map(r=>r.t),t):-1;if(!(s===this.current&&!e)){if(this.current=s,this.box.clientHeight){let r=Math.max(0,s)*Rr,{scrollTop:o,clientHeight:a}=this.box;(r<o||r>o+a-3*Rr)&&(this.box.scrollTop=r-a/3)}this.fill()}}fill(){let t=Math.
max(0,Math.floor(this.box.scrollTop/Rr)-4),e=t+Math.ceil(this.box.clientHeight/Rr)+8;this.rows.replaceChildren(...this.events.slice(t,e).map((n,s)=>{let r=de("div","",`event${t+s===this.current?" on":""}`);r.style.top=`${Rr*(t+s)}px`;let o=de("i"),a=bn.find(c=>c.name===(n.impact||n.system?"impact":n.to))??bn[0];return o.style.background=a.colour,r.append(o,de("span",`${n.t.toFixed(5)}`,"t"),de("sp\
an",n.contact,"c"),de("span",n.impact?`impact ${Bn(n.speed)} m/s`:n.system?n.system:`${n.from} \u2192 ${n.to}`,"k")),r.title=n.impact?`impulse ${Bn(n.impulse)} N s`:"",r.onclick=()=>this.seek(n.t),r}))}};function Fd(i){let t=de("pre");for(let e of i.replace(/\n$/,"").split(`
`)){let n=de("code"),s=e.match(/<!--.*?(-->|$)|<\/?[\w.:-]+|"[^"]*"|\/?>|[^<>"]+|./g)??[];for(let r of s){let o=r.startsWith("<!--")?"note":/^<|^\/?>$/.test(r)?"tag":r.startsWith('"')?"value":"";n.append(o?de("span",r,o):r)}t.append(n)}return t}var gv="uplot",vv="u-hz",_v="u-vt",xv="u-title",yv="u-wrap",Mv="u-under",bv="u-over",Sv="u-axis",Ws="u-off",wv="u-select",Ev="u-cursor-x",Tv="u-cursor-y",Av="u-cursor-pt",Cv="u-legend",Rv="u-live",Pv="u-inline",Iv="u-series",Lv="u-marker",Nd="u-label",Dv="u-value",Oo="width",Bo="height";var Od="bottom",Pr="left",Oh="right",tu="#000",Bd=tu+"0",Bh="mousemove",kd="mousedown",kh="mouseup",zd="mouseenter",Vd="mouseleave",Hd="dblclick",Uv="resize",Fv="scroll",Gd="change",Ya="dppxchange",eu="--",Or=typeof window<"u",Wh=Or?document:null,Lr=Or?window:null,Nv=Or?navigator:null,Ce,Ga;function Xh(){let i=devicePixelRatio;Ce!=i&&(Ce=i,Ga&&Yh(Gd,Ga,Xh),Ga=matchMedia(`(min-resolution: ${Ce-.001}\
dppx) and (max-resolution: ${Ce+.001}dppx)`),Xs(Gd,Ga,Xh),Lr.dispatchEvent(new CustomEvent(Ya)))}function Qn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function qh(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function qe(i,t,e){i.style[t]=e+"px"}function Si(i,t,e,n){let s=Wh.createElement(i);return t!=null&&Qn(s,t),e?.insertBefore(s,n),s}function hi(i,t){return Si("div",i,t)}
var Wd=new WeakMap;function zi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Wd.get(i);r!=o&&(i.style.transform=r,Wd.set(i,r),t<0||e<0||t>n||e>s?Qn(i,Ws):qh(i,Ws))}var Xd=new WeakMap;function qd(i,t,e){let n=t+e,s=Xd.get(i);n!=s&&(Xd.set(i,n),i.style.background=t,i.style.borderColor=e)}var Yd=new WeakMap;function $d(i,t,e,n){let s=t+""+e,r=Yd.get(i);s!=r&&(Yd.set(i,s),i.style.height=e+"px",i.style.
width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var nu={passive:!0},Ov={...nu,capture:!0};function Xs(i,t,e,n){t.addEventListener(i,e,n?Ov:nu)}function Yh(i,t,e,n){t.removeEventListener(i,e,nu)}Or&&Xh();function wi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ti((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function bp(i){return(e,n,s)=>{
let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Sp=i=>i!=null,wp=i=>i!=null&&i>0,Ja=bp(Sp),Bv=bp(wp);function kv(i,t,e,n=0,s=!1){let r=s?Bv:Ja,o=s?wp:Sp;[t,e]=r(i,t,e);let a=i[t],c=i[t];if(t>-1)if(n==1)a=i[t],c=i[e];else if(n==-1)a=i[e],c=i[t];else for(let l=t;l<=e;l++){let h=i[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Oe,c??-Oe]}function Ka(i,t,e,n){
let s=Kd(i),r=Kd(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Ki:Ep,a=s==1?ti:ui,c=r==1?ui:ti,l=a(o(ln(i))),h=c(o(ln(t))),u=Dr(e,l),f=Dr(e,h);return e==10&&(l<0&&(u=Be(u,-l)),h<0&&(f=Be(f,-h))),n||e==2?(i=u*s,t=f*r):(i=Rp(i,u),t=ja(t,f)),[i,t]}function iu(i,t,e,n){let s=Ka(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var su=.1,Zd={mode:3,pad:su},zo={pad:0,soft:null,mode:0},zv={min:zo,max:zo};
function $a(i,t,e,n){return Qa(e)?Jd(i,t,e):(zo.pad=e,zo.soft=n?0:null,zo.mode=n?3:0,Jd(i,t,zv))}function we(i,t){return i??t}function Vv(i,t,e){for(t=we(t,0),e=we(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Jd(i,t,e){let n=e.min,s=e.max,r=we(n.pad,0),o=we(s.pad,0),a=we(n.hard,-Oe),c=we(s.hard,Oe),l=we(n.soft,Oe),h=we(s.soft,-Oe),u=we(n.mode,0),f=we(s.mode,0),d=t-i,g=Ki(d),_=kn(
ln(i),ln(t)),m=Ki(_),p=ln(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&l!=Oe&&(r=0),f==2&&h!=-Oe&&(o=0)));let b=d||_||1e3,T=Ki(b),y=Dr(10,ti(T)),I=b*(d==0?i==0?.1:1:r),A=Be(Rp(i-I,y/10),24),D=i>=l&&(u==1||u==3&&A<=l||u==2&&A>=l)?l:Oe,N=kn(a,A<D&&i>=D?D:Ei(D,A)),w=b*(d==0?t==0?.1:1:o),S=Be(ja(t+w,y/10),24),C=t<=h&&(f==1||f==3&&S>=h||f==2&&S<=h)?h:-Oe,O=Ei(c,S>C&&t<=C?C:kn(C,S));return N==
O&&N==0&&(O=100),[N,O]}var Hv=new Intl.NumberFormat(Or?Nv.language:"en-US"),ru=i=>Hv.format(i),ei=Math,qa=ei.PI,ln=ei.abs,ti=ei.floor,an=ei.round,ui=ei.ceil,Ei=ei.min,kn=ei.max,Dr=ei.pow,Kd=ei.sign,Ki=ei.log10,Ep=ei.log2,Gv=(i,t=1)=>ei.sinh(i)*t,zh=(i,t=1)=>ei.asinh(i/t),Oe=1/0;function jd(i){return(Ki((i^i>>31)-(i>>31))|0)+1}function $h(i,t,e){return Ei(kn(i,t),e)}function Tp(i){return typeof i==
"function"}function pe(i){return Tp(i)?i:()=>i}var Wv=()=>{},Ap=i=>i,Cp=(i,t)=>t,Xv=i=>null,Qd=i=>!0,tp=(i,t)=>i==t,qv=/\.\d*?(?=9{6,}|0{6,})/gm,qs=i=>{if(Ip(i)||Ms.has(i))return i;let t=`${i}`,e=t.match(qv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${qs(s)}e${r}`}return Be(i,n)};function Hs(i,t){return qs(Be(qs(i/t))*t)}function ja(i,t){return qs(
ui(qs(i/t))*t)}function Rp(i,t){return qs(ti(qs(i/t))*t)}function Be(i,t=0){if(Ip(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return an(n)/e}var Ms=new Map;function Pp(i){return((""+i).split(".")[1]||"").length}function Ho(i,t,e,n){let s=[],r=n.map(Pp);for(let o=t;o<e;o++){let a=ln(o),c=Be(Dr(i,o),a);for(let l=0;l<n.length;l++){let h=i==10?+`${n[l]}e${o}`:n[l]*c,u=(o>=0?0:a)+(o>=r[l]?0:r[l]),
f=i==10?h:Be(h,u);s.push(f),Ms.set(f,u)}}return s}var Vo={},ou=[],Ur=[null,null],ys=Array.isArray,Ip=Number.isInteger,Yv=i=>i===void 0;function ep(i){return typeof i=="string"}function Qa(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function $v(i){return i!=null&&typeof i=="object"}var Zv=Object.getPrototypeOf(Uint8Array),Lp="__proto__";function Fr(i,t=Qa){let e;if(ys(
i)){let n=i.find(s=>s!=null);if(ys(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Fr(i[s],t)}else e=i.slice()}else if(i instanceof Zv)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Lp&&(e[n]=Fr(i[n],t))}else e=i;return e}function sn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Lp&&(Qa(i[s])?sn(i[s],Fr(n[s])):i[s]=Fr(n[s]))}return i}var Jv=0,Kv=1,jv=2;function Qv(i,t,e){
for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function t_(i,t){if(i_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return s_(o[0])||(o=n_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let n=[Array.from(e).sort((o,a)=>o-a)],
s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],u=Array(s).fill(void 0),f=t?t[o][l]:Kv,d=[];for(let g=0;g<h.length;g++){let _=h[g],m=r.get(c[g]);_===null?f!=Jv&&(u[m]=_,f==jv&&d.push(m)):u[m]=_}Qv(u,d,s),n.push(u)}}return n}var e_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function n_(i){
let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[n[c]];s.push(a)}return s}function i_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function s_(i,t=100){let e=i.
length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=kn(1,ti((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Dp=["January","February","March","April","May","June","July","August","September","October","November","December"],Up=["Sunday","Monday","Tuesday","Wednesday","Thursday","Frid\
ay","Saturday"];function Fp(i){return i.slice(0,3)}var r_=Up.map(Fp),o_=Dp.map(Fp),a_={MMMM:Dp,MMM:o_,WWWW:Up,WWW:r_};function No(i){return(i<10?"0":"")+i}function l_(i){return(i<10?"00":i<100?"0":"")+i}var c_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>No(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>No(i.getDate()),
D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>No(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>No(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>No(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>l_(i.getMilliseconds())};function au(i,t){
t=t||a_;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?c_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var h_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function u_(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==h_?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),
e.setMilliseconds(i.getMilliseconds())),e}var Np=i=>i%1==0,Za=[1,2,2.5,5],f_=Ho(10,-32,0,Za),Op=Ho(10,0,32,Za),d_=Op.filter(Np),Gs=f_.concat(Op),lu=`
`,Bp="{YYYY}",np=lu+Bp,kp="{M}/{D}",ko=lu+kp,Wa=ko+"/{YY}",zp="{aa}",p_="{h}:{mm}",Ir=p_+zp,ip=lu+Ir,sp=":{ss}",Re=null;function Vp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,c=(i==1?Ho(10,0,3,Za).filter(Np):Ho(10,-3,0,Za)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),
l=[[o,Bp,Re,Re,Re,Re,Re,Re,1],[s*28,"{MMM}",np,Re,Re,Re,Re,Re,1],[s,kp,np,Re,Re,Re,Re,Re,1],[n,"{h}"+zp,Wa,Re,ko,Re,Re,Re,1],[e,Ir,Wa,Re,ko,Re,Re,Re,1],[t,sp,Wa+" "+Ir,Re,ko+" "+Ir,Re,ip,Re,1],[i,sp+".{fff}",Wa+" "+Ir,Re,ko+" "+Ir,Re,ip,Re,1]];function h(u){return(f,d,g,_,m,p)=>{let b=[],T=m>=o,y=m>=r&&m<o,I=u(g),A=Be(I*i,3),D=Vh(I.getFullYear(),T?0:I.getMonth(),y||T?1:I.getDate()),N=Be(D*i,3);if(y||
T){let w=y?m/r:0,S=T?m/o:0,C=A==N?A:Be(Vh(D.getFullYear()+S,D.getMonth()+w,1)*i,3),O=new Date(an(C/i)),z=O.getFullYear(),G=O.getMonth();for(let X=0;C<=_;X++){let q=Vh(z+S*X,G+w*X,1),Z=q-u(Be(q*i,3));C=Be((+q+Z)*i,3),C<=_&&b.push(C)}}else{let w=m>=s?s:m,S=ti(g)-ti(A),C=N+S+ja(A-N,w);b.push(C);let O=u(C),z=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,G=m/n,X=f.axes[d]._space,q=p/X;for(;C=Be(C+m,i==
1?0:3),!(C>_);)if(G>1){let Z=ti(Be(z+G,6))%24,ot=u(C).getHours()-Z;ot>1&&(ot=-1),C-=ot*n,z=(z+G)%24;let vt=b[b.length-1];Be((C-vt)/m,3)*q>=.7&&b.push(C)}else b.push(C)}return b}}return[c,l,h]}var[m_,g_,v_]=Vp(1),[__,x_,y_]=Vp(.001);Ho(2,-53,53,[1]);function rp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function op(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=
g[0])||t[t.length-1],c,l,h,u,f,d;return n.map(g=>{let _=i(g),m=_.getFullYear(),p=_.getMonth(),b=_.getDate(),T=_.getHours(),y=_.getMinutes(),I=_.getSeconds(),A=m!=c&&a[2]||p!=l&&a[3]||b!=h&&a[4]||T!=u&&a[5]||y!=f&&a[6]||I!=d&&a[7]||a[1];return c=m,l=p,h=b,u=T,f=y,d=I,A(_)})}}function M_(i,t){let e=au(t);return(n,s,r,o,a)=>s.map(c=>e(i(c)))}function Vh(i,t,e){return new Date(i,t,e)}function ap(i,t){
return t(i)}var b_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function lp(i,t){return(e,n,s,r)=>r==null?eu:t(i(n))}function S_(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function w_(i,t){return i.series[t].fill(i,t)}var E_={show:!0,live:!0,isolate:!1,mount:Wv,markers:{show:!0,width:2,stroke:S_,fill:w_,dash:"solid"},idx:null,idxs:null,values:[]};function T_(i,t){
let e=i.cursor.points,n=hi(),s=e.size(i,t);qe(n,Oo,s),qe(n,Bo,s);let r=s/-2;qe(n,"marginLeft",r),qe(n,"marginTop",r);let o=e.width(i,t,s);return o&&qe(n,"borderWidth",o),n}function A_(i,t){let e=i.series[t].points;return e._fill||e._stroke}function C_(i,t){let e=i.series[t].points;return e._stroke||e._fill}function R_(i,t){return i.series[t].points.size}var Hh=[0,0];function P_(i,t,e){return Hh[0]=
t,Hh[1]=e,Hh}function Xa(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Gh(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var I_={show:!0,x:!0,y:!0,lock:!1,move:P_,points:{one:!1,show:T_,size:R_,width:0,stroke:C_,fill:A_},bind:{mousedown:Xa,mouseup:Xa,click:Xa,dblclick:Xa,mousemove:Gh,mouseleave:Gh,mouseenter:Gh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),
t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},cu=sn({},Hp,{filter:Cp}),Gp=sn({},cu,{size:10}),Wp=sn({},Hp,{show:!1}),hu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", s\
ans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Xp="bold "+hu,qp=1.5,cp={show:!0,scale:"x",stroke:tu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xp,side:2,grid:cu,ticks:Gp,border:Wp,font:hu,lineGap:qp,rotate:0},L_="Value",D_="Time",hp={show:!0,scale:"x",auto:!1,sorted:1,min:Oe,max:-Oe,idxs:[]};function U_(i,t,e,n,s){return t.map(r=>r==
null?"":ru(r))}function F_(i,t,e,n,s,r,o){let a=[],c=Ms.get(s)||0;e=o?e:Be(ja(e,s),c);for(let l=e;l<=n;l=Be(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Zh(i,t,e,n,s,r,o){let a=[],c=i.scales[i.axes[t].scale].log,l=c==10?Ki:Ep,h=ti(l(e));s=Dr(c,h),c==10&&(s=Gs[wi(s,Gs)]);let u=e,f=s*c;c==10&&(f=Gs[wi(f,Gs)]);do a.push(u),u=u+s,c==10&&!Ms.has(u)&&(u=Be(u,Ms.get(s))),u>=f&&(s=u,f=s*c,c==10&&(f=
Gs[wi(f,Gs)]));while(u<=n);return a}function N_(i,t,e,n,s,r,o){let c=i.scales[i.axes[t].scale].asinh,l=n>c?Zh(i,t,kn(c,e),n,s):[c],h=n>=0&&e<=0?[0]:[];return(e<-c?Zh(i,t,kn(c,-n),-e,s):[c]).reverse().map(f=>-f).concat(h,l)}var Yp=/./,O_=/[12357]/,B_=/[125]/,up=/1/,Jh=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function k_(i,t,e,n,s){let r=i.axes[e],o=r.scale,
a=i.scales[o],c=i.valToPos,l=r._space,h=c(10,o),u=c(9,o)-h>=l?Yp:c(7,o)-h>=l?O_:c(5,o)-h>=l?B_:up;if(u==up){let f=ln(c(1,o)-h);if(f<l)return Jh(t.slice().reverse(),a.distr,u,ui(l/f)).reverse()}return Jh(t,a.distr,u,1)}function z_(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,c=i.valToPos,l=ln(c(1,o)-c(2,o));return l<a?Jh(t.slice().reverse(),3,Yp,ui(a/l)).reverse():t}function V_(i,t,e,n){return n==
null?eu:t==null?"":ru(t)}var fp={show:!0,scale:"y",stroke:tu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xp,side:3,grid:cu,ticks:Gp,border:Wp,font:hu,lineGap:qp,rotate:0};function H_(i,t){let e=3+(i||1)*2;return Be(e*t,3)}function G_(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=ln(o-r),c=i.series[t],l=a/(c.points.space*
Ce);return n[1]-n[0]<=l}var dp={scale:null,auto:!0,sorted:0,min:Oe,max:-Oe},$p=(i,t,e,n,s)=>s,pp={show:!0,auto:!0,sorted:0,gaps:$p,alpha:1,facets:[sn({},dp,{scale:"x"}),sn({},dp,{scale:"y"})]},mp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$p,alpha:1,points:{show:G_,filter:null},values:null,min:Oe,max:-Oe,idxs:[],path:null,clip:null};function W_(i,t,e,n,s){return e/10}var Zp={time:!0,auto:!0,
distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},X_=sn({},Zp,{time:!1,ori:1}),gp={};function Jp(i,t){let e=gp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,c,l)}},i!=null&&(gp[i]=e)),e}var Nr=1,Kh=2;function Ys(i,t,e){let n=i.mode,s=i.series[t],r=n==2?
i._data[t]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,_=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?e(s,c,l,h,u,m,p,f,d,g,_,el,Br,il,jp,tm):e(s,c,l,h,u,p,m,d,f,_,g,nl,kr,du,Qp,em)}function uu(i,t){let e=0,n=0,s=we(i.bands,ou);for(let r=0;r<s.length;r++){let o=s[r];o.
series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function q_(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ji(i,t,e,n,s,r){return Ys(i,t,(o,a,c,l,h,u,f,d,g,_,m)=>{let p=o.pxRound,b=l.dir*(l.ori==0?1:-1),T=l.ori==0?Br:kr,y,I;b==1?(y=e,I=n):(y=n,I=
e);let A=p(u(a[y],l,_,d)),D=p(f(c[y],h,m,g)),N=p(u(a[I],l,_,d)),w=p(f(r==1?h.max:h.min,h,m,g)),S=new Path2D(s);return T(S,N,w),T(S,A,w),T(S,A,D),S})}function tl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?il:du,c=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-c;d>0&&a(o,c,n,d,n+r),c=f[1]}}let l=e+s-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function Y_(i,t,e){let n=i[i.
length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function fu(i,t,e,n,s,r,o){let a=[],c=i.length;for(let l=s==1?e:n;l>=e&&l<=n;l+=s)if(t[l]===null){let u=l,f=l;if(s==1)for(;++l<=n&&t[l]===null;)f=l;else for(;--l>=e&&t[l]===null;)f=l;let d=r(i[u]),g=f==u?d:r(i[f]),_=u-s;d=o<=0&&_>=0&&_<c?r(i[_]):d;let p=f+s;g=o>=0&&p>=0&&p<c?r(i[p]):g,g>=d&&a.push([d,g])}return a}function vp(i){return i==0?Ap:i==1?an:t=>Hs(
t,i)}function Kp(i){let t=i==0?el:nl,e=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(s,r,o,a,c):(l=Ei(l,a/2,c/2),h=Ei(h,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,h),e(s,r,o+c,r,o,h),e(s,r,o,r+a,o,l),s.closePath())}}var el=(i,t,e)=>{i.moveTo(t,
e)},nl=(i,t,e)=>{i.moveTo(e,t)},Br=(i,t,e)=>{i.lineTo(t,e)},kr=(i,t,e)=>{i.lineTo(e,t)},il=Kp(0),du=Kp(1),jp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Qp=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},tm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},em=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function nm(i){return(t,e,n,s,r)=>Ys(t,e,(o,a,c,l,h,u,f,d,g,_,m)=>{let{pxRound:p,points:b}=o,T,y;l.ori==0?(T=el,y=jp):
(T=nl,y=Qp);let I=Be(b.width*Ce,3),A=(b.size-b.width)/2*Ce,D=Be(A*2,3),N=new Path2D,w=new Path2D,{left:S,top:C,width:O,height:z}=t.bbox;il(w,S-D,C-D,O+D*2,z+D*2);let G=X=>{if(c[X]!=null){let q=p(u(a[X],l,_,d)),Z=p(f(c[X],h,m,g));T(N,q+A,Z),y(N,q,Z,A,0,qa*2)}};if(r)r.forEach(G);else for(let X=n;X<=s;X++)G(X);return{stroke:I>0?N:null,fill:N,clip:w,flags:Nr|Kh}})}function im(i){return(t,e,n,s,r,o)=>{
n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var $_=im(Br),Z_=im(kr);function sm(i){let t=we(i?.alignGaps,0);return(e,n,s,r)=>Ys(e,n,(o,a,c,l,h,u,f,d,g,_,m)=>{[s,r]=Ja(c,s,r);let p=o.pxRound,b=z=>p(u(z,l,_,d)),T=z=>p(f(z,h,m,g)),y,I;l.ori==0?(y=Br,I=$_):(y=kr,I=Z_);let A=l.dir*(l.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Nr},N=D.stroke,w=!1;if(r-
s>=_*4){let z=pt=>e.posToVal(pt,l.key,!0),G=null,X=null,q,Z,j,rt=b(a[A==1?s:r]),ot=b(a[s]),vt=b(a[r]),xt=z(A==1?ot+1:vt-1);for(let pt=A==1?s:r;pt>=s&&pt<=r;pt+=A){let ee=a[pt],Q=(A==1?ee<xt:ee>xt)?rt:b(ee),tt=c[pt];Q==rt?tt!=null?(Z=tt,G==null?(y(N,Q,T(Z)),q=G=X=Z):Z<G?G=Z:Z>X&&(X=Z)):tt===null&&(w=!0):(G!=null&&I(N,rt,T(G),T(X),T(q),T(Z)),tt!=null?(Z=tt,y(N,Q,T(Z)),G=X=q=Z):(G=X=null,tt===null&&(w=
!0)),rt=Q,xt=z(rt+A))}G!=null&&G!=X&&j!=rt&&I(N,rt,T(G),T(X),T(q),T(Z))}else for(let z=A==1?s:r;z>=s&&z<=r;z+=A){let G=c[z];G===null?w=!0:G!=null&&y(N,b(a[z]),T(G))}let[C,O]=uu(e,n);if(o.fill!=null||C!=0){let z=D.fill=new Path2D(N),G=o.fillTo(e,n,o.min,o.max,C),X=T(G),q=b(a[s]),Z=b(a[r]);A==-1&&([Z,q]=[q,Z]),y(z,Z,X),y(z,q,X)}if(!o.spanGaps){let z=[];w&&z.push(...fu(a,c,s,r,A,b,t)),D.gaps=z=o.gaps(
e,n,s,r,z),D.clip=tl(z,l.ori,d,g,_,m)}return O!=0&&(D.band=O==2?[ji(e,n,s,r,N,-1),ji(e,n,s,r,N,1)]:ji(e,n,s,r,N,O)),D})}function J_(i){let t=we(i.align,1),e=we(i.ascDesc,!1),n=we(i.alignGaps,0),s=we(i.extend,!1);return(r,o,a,c)=>Ys(r,o,(l,h,u,f,d,g,_,m,p,b,T)=>{[a,c]=Ja(u,a,c);let y=l.pxRound,{left:I,width:A}=r.bbox,D=ot=>y(g(ot,f,b,m)),N=ot=>y(_(ot,d,T,p)),w=f.ori==0?Br:kr,S={stroke:new Path2D,fill:null,
clip:null,band:null,gaps:null,flags:Nr},C=S.stroke,O=f.dir*(f.ori==0?1:-1),z=N(u[O==1?a:c]),G=D(h[O==1?a:c]),X=G,q=G;s&&t==-1&&(q=I,w(C,q,z)),w(C,G,z);for(let ot=O==1?a:c;ot>=a&&ot<=c;ot+=O){let vt=u[ot];if(vt==null)continue;let xt=D(h[ot]),pt=N(vt);t==1?w(C,xt,z):w(C,X,pt),w(C,xt,pt),z=pt,X=xt}let Z=X;s&&t==1&&(Z=I+A,w(C,Z,z));let[j,rt]=uu(r,o);if(l.fill!=null||j!=0){let ot=S.fill=new Path2D(C),vt=l.
fillTo(r,o,l.min,l.max,j),xt=N(vt);w(ot,Z,xt),w(ot,q,xt)}if(!l.spanGaps){let ot=[];ot.push(...fu(h,u,a,c,O,D,n));let vt=l.width*Ce/2,xt=e||t==1?vt:-vt,pt=e||t==-1?-vt:vt;ot.forEach(ee=>{ee[0]+=xt,ee[1]+=pt}),S.gaps=ot=l.gaps(r,o,a,c,ot),S.clip=tl(ot,f.ori,m,p,b,T)}return rt!=0&&(S.band=rt==2?[ji(r,o,a,c,C,-1),ji(r,o,a,c,C,1)]:ji(r,o,a,c,C,rt)),S})}function _p(i,t,e,n,s,r,o=Oe){if(i.length>1){let a=null;
for(let c=0,l=1/0;c<i.length;c++)if(t[c]!==void 0){if(a!=null){let h=ln(i[c]-i[a]);h<l&&(l=h,o=ln(e(i[c],n,s,r)-e(i[a],n,s,r)))}a=c}}return o}function K_(i){i=i||Vo;let t=we(i.size,[.6,Oe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=pe(s),o=1-t[0],a=we(t[1],Oe),c=we(t[2],1),l=we(i.disp,Vo),h=we(i.each,d=>{}),{fill:u,stroke:f}=l;return(d,g,_,m)=>Ys(d,g,(p,b,T,y,I,A,D,N,w,S,C)=>{
let O=p.pxRound,z=e,G=n*Ce,X=a*Ce,q=c*Ce,Z,j;y.ori==0?[Z,j]=r(d,g):[j,Z]=r(d,g);let rt=y.dir*(y.ori==0?1:-1),ot=y.ori==0?il:du,vt=y.ori==0?h:(F,J,nt,et,Nt,ht,Lt)=>{h(F,J,nt,Nt,et,Lt,ht)},xt=we(d.bands,ou).find(F=>F.series[0]==g),pt=xt!=null?xt.dir:0,ee=p.fillTo(d,g,p.min,p.max,pt),Zt=O(D(ee,I,C,w)),Q,tt,Mt,Ot=S,_t=O(p.width*Ce),Qt=!1,Pe=null,U=null,xe=null,Kt=null;u!=null&&(_t==0||f!=null)&&(Qt=!0,
Pe=u.values(d,g,_,m),U=new Map,new Set(Pe).forEach(F=>{F!=null&&U.set(F,new Path2D)}),_t>0&&(xe=f.values(d,g,_,m),Kt=new Map,new Set(xe).forEach(F=>{F!=null&&Kt.set(F,new Path2D)})));let{x0:qt,size:Ft}=l;if(qt!=null&&Ft!=null){z=1,b=qt.values(d,g,_,m),qt.unit==2&&(b=b.map(nt=>d.posToVal(N+nt*S,y.key,!0)));let F=Ft.values(d,g,_,m);Ft.unit==2?tt=F[0]*S:tt=A(F[0],y,S,N)-A(0,y,S,N),Ot=_p(b,T,A,y,S,N,Ot),
Mt=Ot-tt+G}else Ot=_p(b,T,A,y,S,N,Ot),Mt=Ot*o+G,tt=Ot-Mt;Mt<1&&(Mt=0),_t>=tt/2&&(_t=0),Mt<5&&(O=Ap);let Ie=Mt>0,Pt=Ot-Mt-(Ie?_t:0);tt=O($h(Pt,q,X)),Q=(z==0?tt/2:z==rt?0:tt)-z*rt*((z==0?G/2:0)+(Ie?_t/2:0));let Xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},He=Qt?null:new Path2D,Ee=null;if(xt!=null)Ee=d.data[xt.series[1]];else{let{y0:F,y1:J}=l;F!=null&&J!=null&&(T=J.values(d,g,_,m),
Ee=F.values(d,g,_,m))}let P=Z*tt,x=j*tt;for(let F=rt==1?_:m;F>=_&&F<=m;F+=rt){let J=T[F];if(J==null)continue;if(Ee!=null){let gt=Ee[F]??0;if(J-gt==0)continue;Zt=D(gt,I,C,w)}let nt=y.distr!=2||l!=null?b[F]:F,et=A(nt,y,S,N),Nt=D(we(J,ee),I,C,w),ht=O(et-Q),Lt=O(kn(Nt,Zt)),At=O(Ei(Nt,Zt)),at=Lt-At;if(J!=null){let gt=J<0?x:P,zt=J<0?P:x;Qt?(_t>0&&xe[F]!=null&&ot(Kt.get(xe[F]),ht,At+ti(_t/2),tt,kn(0,at-_t),
gt,zt),Pe[F]!=null&&ot(U.get(Pe[F]),ht,At+ti(_t/2),tt,kn(0,at-_t),gt,zt)):ot(He,ht,At+ti(_t/2),tt,kn(0,at-_t),gt,zt),vt(d,g,F,ht-_t/2,At,tt+_t,at)}}return _t>0?Xt.stroke=Qt?Kt:He:Qt||(Xt._fill=p.width==0?p._fill:p._stroke??p._fill,Xt.width=0),Xt.fill=Qt?U:He,Xt})}function j_(i,t){let e=we(t?.alignGaps,0);return(n,s,r,o)=>Ys(n,s,(a,c,l,h,u,f,d,g,_,m,p)=>{[r,o]=Ja(l,r,o);let b=a.pxRound,T=Z=>b(f(Z,h,
m,g)),y=Z=>b(d(Z,u,p,_)),I,A,D;h.ori==0?(I=el,D=Br,A=tm):(I=nl,D=kr,A=em);let N=h.dir*(h.ori==0?1:-1),w=T(c[N==1?r:o]),S=w,C=[],O=[];for(let Z=N==1?r:o;Z>=r&&Z<=o;Z+=N)if(l[Z]!=null){let rt=c[Z],ot=T(rt);C.push(S=ot),O.push(y(l[Z]))}let z={stroke:i(C,O,I,D,A,b),fill:null,clip:null,band:null,gaps:null,flags:Nr},G=z.stroke,[X,q]=uu(n,s);if(a.fill!=null||X!=0){let Z=z.fill=new Path2D(G),j=a.fillTo(n,
s,a.min,a.max,X),rt=y(j);D(Z,S,rt),D(Z,w,rt)}if(!a.spanGaps){let Z=[];Z.push(...fu(c,l,r,o,N,T,e)),z.gaps=Z=a.gaps(n,s,r,o,Z),z.clip=tl(Z,h.ori,g,_,m,p)}return q!=0&&(z.band=q==2?[ji(n,s,r,o,G,-1),ji(n,s,r,o,G,1)]:ji(n,s,r,o,G,q)),z})}function Q_(i){return j_(tx,i)}function tx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let c=Array(o),
l=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],l[f]=h[f]/u[f];c[0]=l[0];for(let f=1;f<o-1;f++)l[f]===0||l[f-1]===0||l[f-1]>0!=l[f]>0?c[f]=0:(c[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/l[f-1]+(u[f]+2*u[f-1])/l[f]),isFinite(c[f])||(c[f]=0));c[o-1]=l[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+c[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-c[f+1]*u[f]/3,i[f+1],t[f+1])}
return a}var jh=new Set;function xp(){for(let i of jh)i.syncRect(!0)}Or&&(Xs(Uv,Lr,xp),Xs(Fv,Lr,xp,!0),Xs(Ya,Lr,()=>{_n.pxRatio=Ce}));var ex=sm(),nx=nm();function yp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Qh(r,o,t,e))}function ix(i,t){return i.map((e,n)=>n==0?{}:sn({},t,e))}function Qh(i,t,e,n){return sn({},t==0?e:n,i)}function rm(i,t,e){return t==null?
Ur:[t,e]}var sx=rm;function rx(i,t,e){return t==null?Ur:$a(t,e,su,!0)}function om(i,t,e,n){return t==null?Ur:Ka(t,e,i.scales[n].log,!1)}var ox=om;function am(i,t,e,n){return t==null?Ur:iu(t,e,i.scales[n].log,!1)}var ax=am;function lx(i,t,e,n,s){let r=kn(jd(i),jd(t)),o=t-i,a=wi(s/n*o,e);do{let c=e[a],l=n*c/o;if(l>=s&&r+(c<5?Ms.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Mp(i){
let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=an((e=+s)*Ce))+"px"),[i,t,e]}function cx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Be(t[2]*Ce,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function _n(i,t,e){let n={mode:we(i.mode,1)},s=n.mode;function r(v,M,R,L){let k=M.valToPct(v);return L+R*(M.dir==-1?1-k:k)}function o(v,M,R,L){let k=M.valToPct(v);return L+R*(M.dir==-1?k:1-k)}function a(v,M,R,L){
return M.ori==0?r(v,M,R,L):o(v,M,R,L)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=hi(gv);if(i.id!=null&&(l.id=i.id),Qn(l,i.class),i.title){let v=hi(xv,l);v.textContent=i.title}let h=Si("canvas"),u=n.ctx=h.getContext("2d"),f=hi(yv,l);Xs("click",f,v=>{v.target===g&&(Ge!=xr||$e!=yr)&&Mn.click(n,v)},!0);let d=n.under=hi(Mv,f);f.appendChild(h);let g=n.over=hi(bv,f);i=Fr(i);let _=+we(i.
pxAlign,1),m=vp(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let p=i.ms||.001,b=n.series=s==1?yp(i.series||[],hp,mp,!1):ix(i.series||[null],pp),T=n.axes=yp(i.axes||[],cp,fp,!0),y=n.scales={},I=n.bands=i.bands||[];I.forEach(v=>{v.fill=pe(v.fill||null),v.dir=we(v.dir,-1)});let A=s==2?b[1].facets[0].scale:b[0].scale,D={axes:L0,series:Os},N=(i.drawOrder||["axes","series"]).map(v=>D[v]);
function w(v){let M=v.distr==3?R=>Ki(R>0?R:v.clamp(n,R,v.min,v.max,v.key)):v.distr==4?R=>zh(R,v.asinh):v.distr==100?R=>v.fwd(R):R=>R;return R=>{let L=M(R),{_min:k,_max:Y}=v,it=Y-k;return(L-k)/it}}function S(v){let M=y[v];if(M==null){let R=(i.scales||Vo)[v]||Vo;if(R.from!=null){S(R.from);let L=sn({},y[R.from],R,{key:v});L.valToPct=w(L),y[v]=L}else{M=y[v]=sn({},v==A?Zp:X_,R),M.key=v;let L=M.time,k=M.
range,Y=ys(k);if((v!=A||s==2&&!L)&&(Y&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?Zd:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?Zd:{mode:1,hard:k[1],soft:k[1]}},Y=!1),!Y&&Qa(k))){let it=k;k=(lt,mt,Et)=>mt==null?Ur:$a(mt,Et,it)}M.range=pe(k||(L?sx:v==A?M.distr==3?ox:M.distr==4?ax:rm:M.distr==3?om:M.distr==4?am:rx)),M.auto=pe(Y?!1:M.auto),M.clamp=pe(M.clamp||W_),M._min=M._max=null,M.valToPct=w(M)}}}
S("x"),S("y"),s==1&&b.forEach(v=>{S(v.scale)}),T.forEach(v=>{S(v.scale)});for(let v in i.scales)S(v);let C=y[A],O=C.distr,z,G;C.ori==0?(Qn(l,vv),z=r,G=o):(Qn(l,_v),z=o,G=r);let X={};for(let v in y){let M=y[v];(M.min!=null||M.max!=null)&&(X[v]={min:M.min,max:M.max},M.min=M.max=null)}let q=i.tzDate||(v=>new Date(an(v/p))),Z=i.fmtDate||au,j=p==1?v_(q):y_(q),rt=op(q,rp(p==1?g_:x_,Z)),ot=lp(q,ap(b_,Z)),
vt=[],xt=n.legend=sn({},E_,i.legend),pt=n.cursor=sn({},I_,{drag:{y:s==2}},i.cursor),ee=xt.show,Zt=pt.show,Q=xt.markers;xt.idxs=vt,Q.width=pe(Q.width),Q.dash=pe(Q.dash),Q.stroke=pe(Q.stroke),Q.fill=pe(Q.fill);let tt,Mt,Ot,_t=[],Qt=[],Pe,U=!1,xe={};if(xt.live){let v=b[1]?b[1].values:null;U=v!=null,Pe=U?v(n,1,0):{_:0};for(let M in Pe)xe[M]=eu}if(ee)if(tt=Si("table",Cv,l),Ot=Si("tbody",null,tt),xt.mount(
n,tt),U){Mt=Si("thead",null,tt,Ot);let v=Si("tr",null,Mt);Si("th",null,v);for(var Kt in Pe)Si("th",Nd,v).textContent=Kt}else Qn(tt,Pv),xt.live&&Qn(tt,Rv);let qt={show:!0},Ft={show:!1};function Ie(v,M){if(M==0&&(U||!xt.live||s==2))return Ur;let R=[],L=Si("tr",Iv,Ot,Ot.childNodes[M]);Qn(L,v.class),v.show||Qn(L,Ws);let k=Si("th",null,L);if(Q.show){let lt=hi(Lv,k);if(M>0){let mt=Q.width(n,M);mt&&(lt.style.
border=mt+"px "+Q.dash(n,M)+" "+Q.stroke(n,M)),lt.style.background=Q.fill(n,M)}}let Y=hi(Nd,k);v.label instanceof HTMLElement?Y.appendChild(v.label):Y.textContent=v.label,M>0&&(Q.show||(Y.style.color=v.width>0?Q.stroke(n,M):Q.fill(n,M)),Xt("click",k,lt=>{if(pt._lock)return;yn(lt);let mt=b.indexOf(v);if((lt.ctrlKey||lt.metaKey)!=xt.isolate){let Et=b.some((Ct,Ut)=>Ut>0&&Ut!=mt&&Ct.show);b.forEach((Ct,Ut)=>{
Ut>0&&Ni(Ut,Et?Ut==mt?qt:Ft:qt,!0,nn.setSeries)})}else Ni(mt,{show:!v.show},!0,nn.setSeries)},!1),Vn&&Xt(zd,k,lt=>{pt._lock||(yn(lt),Ni(b.indexOf(v),br,!0,nn.setSeries))},!1));for(var it in Pe){let lt=Si("td",Dv,L);lt.textContent="--",R.push(lt)}return[L,R]}let Pt=new Map;function Xt(v,M,R,L=!0){let k=Pt.get(M)||{},Y=pt.bind[v](n,M,R,L);Y&&(Xs(v,M,k[v]=Y),Pt.set(M,k))}function He(v,M,R){let L=Pt.get(
M)||{};for(let k in L)(v==null||k==v)&&(Yh(k,M,L[k]),delete L[k]);v==null&&Pt.delete(M)}let Ee=0,P=0,x=0,F=0,J=0,nt=0,et=J,Nt=nt,ht=x,Lt=F,At=0,at=0,gt=0,zt=0;n.bbox={};let kt=!1,yt=!1,te=!1,B=!1,ut=!1,dt=!1;function It(v,M,R){(R||v!=n.width||M!=n.height)&&ct(v,M),mr(!1),te=!0,yt=!0,gr()}function ct(v,M){n.width=Ee=x=v,n.height=P=F=M,J=nt=0,Ue(),Me();let R=n.bbox;At=R.left=Hs(J*Ce,.5),at=R.top=Hs(
nt*Ce,.5),gt=R.width=Hs(x*Ce,.5),zt=R.height=Hs(F*Ce,.5)}let st=3;function Bt(){let v=!1,M=0;for(;!v;){M++;let R=P0(M),L=I0(M);v=M==st||R&&L,v||(ct(n.width,n.height),yt=!0)}}function ne({width:v,height:M}){It(v,M)}n.setSize=ne;function Ue(){let v=!1,M=!1,R=!1,L=!1;T.forEach((k,Y)=>{if(k.show&&k._show){let{side:it,_size:lt}=k,mt=it%2,Et=k.label!=null?k.labelSize:0,Ct=lt+Et;Ct>0&&(mt?(x-=Ct,it==3?(J+=
Ct,L=!0):R=!0):(F-=Ct,it==0?(nt+=Ct,v=!0):M=!0))}}),$i[0]=v,$i[1]=R,$i[2]=M,$i[3]=L,x-=Fi[1]+Fi[3],J+=Fi[3],F-=Fi[2]+Fi[0],nt+=Fi[0]}function Me(){let v=J+x,M=nt+F,R=J,L=nt;function k(Y,it){switch(Y){case 1:return v+=it,v-it;case 2:return M+=it,M-it;case 3:return R-=it,R+it;case 0:return L-=it,L+it}}T.forEach((Y,it)=>{if(Y.show&&Y._show){let lt=Y.side;Y._pos=k(lt,Y._size),Y.label!=null&&(Y._lpos=k(
lt,Y.labelSize))}})}if(pt.dataIdx==null){let v=pt.hover,M=v.skip=new Set(v.skip??[]);M.add(void 0);let R=v.prox=pe(v.prox),L=v.bias??=0;pt.dataIdx=(k,Y,it,lt)=>{if(Y==0)return it;let mt=it,Et=R(k,Y,it,lt)??Oe,Ct=Et>=0&&Et<Oe,Ut=C.ori==0?x:F,ie=pt.left,Te=t[0],Se=t[Y];if(M.has(Se[it])){mt=null;let he=null,jt=null,Wt;if(L==0||L==-1)for(Wt=it;he==null&&Wt-- >0;)M.has(Se[Wt])||(he=Wt);if(L==0||L==1)for(Wt=
it;jt==null&&Wt++<Se.length;)M.has(Se[Wt])||(jt=Wt);if(he!=null||jt!=null)if(Ct){let Xe=he==null?-1/0:z(Te[he],C,Ut,0),Qe=jt==null?1/0:z(Te[jt],C,Ut,0),gn=ie-Xe,Fe=Qe-ie;gn<=Fe?gn<=Et&&(mt=he):Fe<=Et&&(mt=jt)}else mt=jt==null?he:he==null?jt:it-he<=jt-it?he:jt}else Ct&&ln(ie-z(Te[it],C,Ut,0))>Et&&(mt=null);return mt}}let yn=v=>{pt.event=v};pt.idxs=vt,pt._lock=!1;let Ne=pt.points;Ne.show=pe(Ne.show),
Ne.size=pe(Ne.size),Ne.stroke=pe(Ne.stroke),Ne.width=pe(Ne.width),Ne.fill=pe(Ne.fill);let $n=n.focus=sn({},i.focus||{alpha:.3},pt.focus),Vn=$n.prox>=0,Ui=Vn&&Ne.one,In=[],Yi=[],vi=[];function To(v,M){let R=Ne.show(n,M);if(R instanceof HTMLElement)return Qn(R,Av),Qn(R,v.class),zi(R,-10,-10,x,F),g.insertBefore(R,In[M]),R}function Fs(v,M){if(s==1||M>0){let R=s==1&&y[v.scale].time,L=v.value;v.value=R?
ep(L)?lp(q,ap(L,Z)):L||ot:L||V_,v.label=v.label||(R?D_:L_)}if(Ui||M>0){v.width=v.width==null?1:v.width,v.paths=v.paths||ex||Xv,v.fillTo=pe(v.fillTo||q_),v.pxAlign=+we(v.pxAlign,_),v.pxRound=vp(v.pxAlign),v.stroke=pe(v.stroke||null),v.fill=pe(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let R=H_(kn(1,v.width),1),L=v.points=sn({},{size:R,width:kn(1,R*.2),stroke:v.stroke,space:R*2,paths:nx,
_stroke:null,_fill:null},v.points);L.show=pe(L.show),L.filter=pe(L.filter),L.fill=pe(L.fill),L.stroke=pe(L.stroke),L.paths=pe(L.paths),L.pxAlign=v.pxAlign}if(ee){let R=Ie(v,M);_t.splice(M,0,R[0]),Qt.splice(M,0,R[1]),xt.values.push(null)}if(Zt){vt.splice(M,0,null);let R=null;Ui?M==0&&(R=To(v,M)):M>0&&(R=To(v,M)),In.splice(M,0,R),Yi.splice(M,0,0),vi.splice(M,0,0)}mn("addSeries",M)}function Ra(v,M){M=
M??b.length,v=s==1?Qh(v,M,hp,mp):Qh(v,M,{},pp),b.splice(M,0,v),Fs(b[M],M)}n.addSeries=Ra;function Pa(v){if(b.splice(v,1),ee){xt.values.splice(v,1),Qt.splice(v,1);let M=_t.splice(v,1)[0];He(null,M.firstChild),M.remove()}Zt&&(vt.splice(v,1),In.splice(v,1)[0].remove(),Yi.splice(v,1),vi.splice(v,1)),mn("delSeries",v)}n.delSeries=Pa;let $i=[!1,!1,!1,!1];function ph(v,M){if(v._show=v.show,v.show){let R=v.
side%2,L=y[v.scale];L==null&&(v.scale=R?b[1].scale:A,L=y[v.scale]);let k=L.time;v.size=pe(v.size),v.space=pe(v.space),v.rotate=pe(v.rotate),ys(v.incrs)&&v.incrs.forEach(it=>{!Ms.has(it)&&Ms.set(it,Pp(it))}),v.incrs=pe(v.incrs||(L.distr==2?d_:k?p==1?m_:__:Gs)),v.splits=pe(v.splits||(k&&L.distr==1?j:L.distr==3?Zh:L.distr==4?N_:F_)),v.stroke=pe(v.stroke),v.grid.stroke=pe(v.grid.stroke),v.ticks.stroke=
pe(v.ticks.stroke),v.border.stroke=pe(v.border.stroke);let Y=v.values;v.values=ys(Y)&&!ys(Y[0])?pe(Y):k?ys(Y)?op(q,rp(Y,Z)):ep(Y)?M_(q,Y):Y||rt:Y||U_,v.filter=pe(v.filter||(L.distr>=3&&L.log==10?k_:L.distr==3&&L.log==2?z_:Cp)),v.font=Mp(v.font),v.labelFont=Mp(v.labelFont),v._size=v.size(n,null,M,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&($i[M]=!0,v._el=hi(Sv,f))}}
function Ns(v,M,R,L){let[k,Y,it,lt]=R,mt=M%2,Et=0;return mt==0&&(lt||Y)&&(Et=M==0&&!k||M==2&&!it?an(cp.size/3):0),mt==1&&(k||it)&&(Et=M==1&&!Y||M==3&&!lt?an(fp.size/2):0),Et}let Ia=n.padding=(i.padding||[Ns,Ns,Ns,Ns]).map(v=>pe(we(v,Ns))),Fi=n._padding=Ia.map((v,M)=>v(n,M,$i,0)),on,E=null,V=null,K=s==1?b[0].idxs:null,$=null,H=!1;function ft(v,M){if(t=v??[],n.data=n._data=t,s==2){on=0;for(let R=1;R<
b.length;R++)on+=t[R][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),$=t[0],on=$.length;let R=t;if(O==2){R=t.slice();let L=R[0]=Array(on);for(let k=0;k<on;k++)L[k]=k}n._data=t=R}if(mr(!0),mn("setData"),O==2&&(te=!0),M!==!1){let R=C;R.auto(n,H)?bt():gs(A,R.min,R.max),B=B||pt.left>=0,dt=!0,gr()}}n.setData=ft;function bt(){H=!0;let v,M;s==1&&(on>0?(E=K[0]=0,V=K[1]=on-1,v=t[0][E],M=t[0][V],O==2?(v=
E,M=V):v==M&&(O==3?[v,M]=Ka(v,v,C.log,!1):O==4?[v,M]=iu(v,v,C.log,!1):C.time?M=v+an(86400/p):[v,M]=$a(v,M,su,!0))):(E=K[0]=v=null,V=K[1]=M=null)),gs(A,v,M)}let Dt,wt,$t,Jt,Gt,le,be,ke,Le,re;function Yt(v,M,R,L,k,Y){v??=Bd,R??=ou,L??="butt",k??=Bd,Y??="round",v!=Dt&&(u.strokeStyle=Dt=v),k!=wt&&(u.fillStyle=wt=k),M!=$t&&(u.lineWidth=$t=M),Y!=Gt&&(u.lineJoin=Gt=Y),L!=le&&(u.lineCap=le=L),R!=Jt&&u.setLineDash(
Jt=R)}function ze(v,M,R,L){M!=wt&&(u.fillStyle=wt=M),v!=be&&(u.font=be=v),R!=ke&&(u.textAlign=ke=R),L!=Le&&(u.textBaseline=Le=L)}function fe(v,M,R,L,k=0){if(L.length>0&&v.auto(n,H)&&(M==null||M.min==null)){let Y=we(E,0),it=we(V,L.length-1),lt=R.min==null?kv(L,Y,it,k,v.distr==3):[R.min,R.max];v.min=Ei(v.min,R.min=lt[0]),v.max=kn(v.max,R.max=lt[1])}}let En={min:null,max:null};function ds(){for(let L in y){
let k=y[L];X[L]==null&&(k.min==null||X[A]!=null&&k.auto(n,H))&&(X[L]=En)}for(let L in y){let k=y[L];X[L]==null&&k.from!=null&&X[k.from]!=null&&(X[L]=En)}X[A]!=null&&mr(!0);let v={};for(let L in X){let k=X[L];if(k!=null){let Y=v[L]=Fr(y[L],$v);if(k.min!=null)sn(Y,k);else if(L!=A||s==2)if(on==0&&Y.from==null){let it=Y.range(n,null,null,L);Y.min=it[0],Y.max=it[1]}else Y.min=Oe,Y.max=-Oe}}if(on>0){b.forEach(
(L,k)=>{if(s==1){let Y=L.scale,it=X[Y];if(it==null)return;let lt=v[Y];if(k==0){let mt=lt.range(n,lt.min,lt.max,Y);lt.min=mt[0],lt.max=mt[1],E=wi(lt.min,t[0]),V=wi(lt.max,t[0]),V-E>1&&(t[0][E]<lt.min&&E++,t[0][V]>lt.max&&V--),L.min=$[E],L.max=$[V]}else L.show&&L.auto&&fe(lt,it,L,t[k],L.sorted);L.idxs[0]=E,L.idxs[1]=V}else if(k>0&&L.show&&L.auto){let[Y,it]=L.facets,lt=Y.scale,mt=it.scale,[Et,Ct]=t[k],
Ut=v[lt],ie=v[mt];Ut!=null&&fe(Ut,X[lt],Y,Et,Y.sorted),ie!=null&&fe(ie,X[mt],it,Ct,it.sorted),L.min=it.min,L.max=it.max}});for(let L in v){let k=v[L],Y=X[L];if(k.from==null&&(Y==null||Y.min==null)){let it=k.range(n,k.min==Oe?null:k.min,k.max==-Oe?null:k.max,L);k.min=it[0],k.max=it[1]}}}for(let L in v){let k=v[L];if(k.from!=null){let Y=v[k.from];if(Y.min==null)k.min=k.max=null;else{let it=k.range(n,
Y.min,Y.max,L);k.min=it[0],k.max=it[1]}}}let M={},R=!1;for(let L in v){let k=v[L],Y=y[L];if(Y.min!=k.min||Y.max!=k.max){Y.min=k.min,Y.max=k.max;let it=Y.distr;Y._min=it==3?Ki(Y.min):it==4?zh(Y.min,Y.asinh):it==100?Y.fwd(Y.min):Y.min,Y._max=it==3?Ki(Y.max):it==4?zh(Y.max,Y.asinh):it==100?Y.fwd(Y.max):Y.max,M[L]=R=!0}}if(R){b.forEach((L,k)=>{s==2?k>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});
for(let L in M)te=!0,mn("setScale",L);Zt&&pt.left>=0&&(B=dt=!0)}for(let L in X)X[L]=null}function Ln(v){let M=$h(E-1,0,on-1),R=$h(V+1,0,on-1);for(;v[M]==null&&M>0;)M--;for(;v[R]==null&&R<on-1;)R++;return[M,R]}function Os(){if(on>0){let v=b.some(M=>M._focus)&&re!=$n.alpha;v&&(u.globalAlpha=re=$n.alpha),b.forEach((M,R)=>{if(R>0&&M.show&&(Ve(R,!1),Ve(R,!0),M._paths==null)){let L=re;re!=M.alpha&&(u.globalAlpha=
re=M.alpha);let k=s==2?[0,t[R][0].length-1]:Ln(t[R]);M._paths=M.paths(n,R,k[0],k[1]),re!=L&&(u.globalAlpha=re=L)}}),b.forEach((M,R)=>{if(R>0&&M.show){let L=re;re!=M.alpha&&(u.globalAlpha=re=M.alpha),M._paths!=null&&Dn(R,!1);{let k=M._paths!=null?M._paths.gaps:null,Y=M.points.show(n,R,E,V,k),it=M.points.filter(n,R,Y,k);(Y||it)&&(M.points._paths=M.points.paths(n,R,E,V,it),Dn(R,!0))}re!=L&&(u.globalAlpha=
re=L),mn("drawSeries",R)}}),v&&(u.globalAlpha=re=1)}}function Ve(v,M){let R=M?b[v].points:b[v];R._stroke=R.stroke(n,v),R._fill=R.fill(n,v)}function Dn(v,M){let R=M?b[v].points:b[v],{stroke:L,fill:k,clip:Y,flags:it,_stroke:lt=R._stroke,_fill:mt=R._fill,_width:Et=R.width}=R._paths;Et=Be(Et*Ce,3);let Ct=null,Ut=Et%2/2;M&&mt==null&&(mt=Et>0?"#fff":lt);let ie=R.pxAlign==1&&Ut>0;if(ie&&u.translate(Ut,Ut),
!M){let Te=At-Et/2,Se=at-Et/2,he=gt+Et,jt=zt+Et;Ct=new Path2D,Ct.rect(Te,Se,he,jt)}M?fn(lt,Et,R.dash,R.cap,mt,L,k,it,Y):Hn(v,lt,Et,R.dash,R.cap,mt,L,k,it,Ct,Y),ie&&u.translate(-Ut,-Ut)}function Hn(v,M,R,L,k,Y,it,lt,mt,Et,Ct){let Ut=!1;mt!=0&&I.forEach((ie,Te)=>{if(ie.series[0]==v){let Se=b[ie.series[1]],he=t[ie.series[1]],jt=(Se._paths||Vo).band;ys(jt)&&(jt=ie.dir==1?jt[0]:jt[1]);let Wt,Xe=null;Se.
show&&jt&&Vv(he,E,V)?(Xe=ie.fill(n,Te)||Y,Wt=Se._paths.clip):jt=null,fn(M,R,L,k,Xe,it,lt,mt,Et,Ct,Wt,jt),Ut=!0}}),Ut||fn(M,R,L,k,Y,it,lt,mt,Et,Ct)}let un=Nr|Kh;function fn(v,M,R,L,k,Y,it,lt,mt,Et,Ct,Ut){Yt(v,M,R,L,k),(mt||Et||Ut)&&(u.save(),mt&&u.clip(mt),Et&&u.clip(Et)),Ut?(lt&un)==un?(u.clip(Ut),Ct&&u.clip(Ct),oi(k,it),ps(v,Y,M)):lt&Kh?(oi(k,it),u.clip(Ut),ps(v,Y,M)):lt&Nr&&(u.save(),u.clip(Ut),
Ct&&u.clip(Ct),oi(k,it),u.restore(),ps(v,Y,M)):(oi(k,it),ps(v,Y,M)),(mt||Et||Ut)&&u.restore()}function ps(v,M,R){R>0&&(M instanceof Map?M.forEach((L,k)=>{u.strokeStyle=Dt=k,u.stroke(L)}):M!=null&&v&&u.stroke(M))}function oi(v,M){M instanceof Map?M.forEach((R,L)=>{u.fillStyle=wt=L,u.fill(R)}):M!=null&&v&&u.fill(M)}function R0(v,M,R,L){let k=T[v],Y;if(L<=0)Y=[0,0];else{let it=k._space=k.space(n,v,M,
R,L),lt=k._incrs=k.incrs(n,v,M,R,L,it);Y=lx(M,R,lt,L,it)}return k._found=Y}function mh(v,M,R,L,k,Y,it,lt,mt,Et){let Ct=it%2/2;_==1&&u.translate(Ct,Ct),Yt(lt,it,mt,Et,lt),u.beginPath();let Ut,ie,Te,Se,he=k+(L==0||L==3?-Y:Y);R==0?(ie=k,Se=he):(Ut=k,Te=he);for(let jt=0;jt<v.length;jt++)M[jt]!=null&&(R==0?Ut=Te=v[jt]:ie=Se=v[jt],u.moveTo(Ut,ie),u.lineTo(Te,Se));u.stroke(),_==1&&u.translate(-Ct,-Ct)}function P0(v){
let M=!0;return T.forEach((R,L)=>{if(!R.show)return;let k=y[R.scale];if(k.min==null){R._show&&(M=!1,R._show=!1,mr(!1));return}else R._show||(M=!1,R._show=!0,mr(!1));let Y=R.side,it=Y%2,{min:lt,max:mt}=k,[Et,Ct]=R0(L,lt,mt,it==0?x:F);if(Ct==0)return;let Ut=k.distr==2,ie=R._splits=R.splits(n,L,lt,mt,Et,Ct,Ut),Te=k.distr==2?ie.map(Wt=>$[Wt]):ie,Se=k.distr==2?$[ie[1]]-$[ie[0]]:Et,he=R._values=R.values(
n,R.filter(n,Te,L,Ct,Se),L,Ct,Se);R._rotate=Y==2?R.rotate(n,he,L,Ct):0;let jt=R._size;R._size=ui(R.size(n,he,L,v)),jt!=null&&R._size!=jt&&(M=!1)}),M}function I0(v){let M=!0;return Ia.forEach((R,L)=>{let k=R(n,L,$i,v);k!=Fi[L]&&(M=!1),Fi[L]=k}),M}function L0(){for(let v=0;v<T.length;v++){let M=T[v];if(!M.show||!M._show)continue;let R=M.side,L=R%2,k,Y,it=M.stroke(n,v),lt=R==0||R==3?-1:1,[mt,Et]=M._found;
if(M.label!=null){let Fn=M.labelGap*lt,Kn=an((M._lpos+Fn)*Ce);ze(M.labelFont[0],it,"center",R==2?"top":Od),u.save(),L==1?(k=Y=0,u.translate(Kn,an(at+zt/2)),u.rotate((R==3?-qa:qa)/2)):(k=an(At+gt/2),Y=Kn);let zs=Tp(M.label)?M.label(n,v,mt,Et):M.label;u.fillText(zs,k,Y),u.restore()}if(Et==0)continue;let Ct=y[M.scale],Ut=L==0?gt:zt,ie=L==0?At:at,Te=M._splits,Se=Ct.distr==2?Te.map(Fn=>$[Fn]):Te,he=Ct.
distr==2?$[Te[1]]-$[Te[0]]:mt,jt=M.ticks,Wt=M.border,Xe=jt.show?jt.size:0,Qe=an(Xe*Ce),gn=an((M.alignTo==2?M._size-Xe-M.gap:M.gap)*Ce),Fe=M._rotate*-qa/180,tn=m(M._pos*Ce),Zn=(Qe+gn)*lt,Un=tn+Zn;Y=L==0?Un:0,k=L==1?Un:0;let ai=M.font[0],_i=M.align==1?Pr:M.align==2?Oh:Fe>0?Pr:Fe<0?Oh:L==0?"center":R==3?Oh:Pr,Bi=Fe||L==1?"middle":R==2?"top":Od;ze(ai,it,_i,Bi);let Jn=M.font[1]*M.lineGap,li=Te.map(Fn=>m(
a(Fn,Ct,Ut,ie))),xi=M._values;for(let Fn=0;Fn<xi.length;Fn++){let Kn=xi[Fn];if(Kn!=null){L==0?k=li[Fn]:Y=li[Fn],Kn=""+Kn;let zs=Kn.indexOf(`
`)==-1?[Kn]:Kn.split(/\n/gm);for(let Nn=0;Nn<zs.length;Nn++){let ed=zs[Nn];Fe?(u.save(),u.translate(k,Y+Nn*Jn),u.rotate(Fe),u.fillText(ed,0,0),u.restore()):u.fillText(ed,k,Y+Nn*Jn)}}}jt.show&&mh(li,jt.filter(n,Se,v,Et,he),L,R,tn,Qe,Be(jt.width*Ce,3),jt.stroke(n,v),jt.dash,jt.cap);let ki=M.grid;ki.show&&mh(li,ki.filter(n,Se,v,Et,he),L,L==0?2:1,L==0?at:At,L==0?zt:gt,Be(ki.width*Ce,3),ki.stroke(n,v),
ki.dash,ki.cap),Wt.show&&mh([tn],[1],L==0?1:0,L==0?1:2,L==1?at:At,L==1?zt:gt,Be(Wt.width*Ce,3),Wt.stroke(n,v),Wt.dash,Wt.cap)}mn("drawAxes")}function mr(v){b.forEach((M,R)=>{R>0&&(M._paths=null,v&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let La=!1,gh=!1,Ao=[];function D0(){gh=!1;for(let v=0;v<Ao.length;v++)mn(...Ao[v]);Ao.length=0}function gr(){La||(e_(Of),La=
!0)}function U0(v,M=!1){La=!0,gh=M,v(n),Of(),M&&Ao.length>0&&queueMicrotask(D0)}n.batch=U0;function Of(){if(kt&&(ds(),kt=!1),te&&(Bt(),te=!1),yt){if(qe(d,Pr,J),qe(d,"top",nt),qe(d,Oo,x),qe(d,Bo,F),qe(g,Pr,J),qe(g,"top",nt),qe(g,Oo,x),qe(g,Bo,F),qe(f,Oo,Ee),qe(f,Bo,P),h.width=an(Ee*Ce),h.height=an(P*Ce),T.forEach(({_el:v,_show:M,_size:R,_pos:L,side:k})=>{if(v!=null)if(M){let Y=k===3||k===0?R:0,it=k%
2==1;qe(v,it?"left":"top",L-Y),qe(v,it?"width":"height",R),qe(v,it?"top":"left",it?nt:J),qe(v,it?"height":"width",it?F:x),qh(v,Ws)}else Qn(v,Ws)}),Dt=wt=$t=Gt=le=be=ke=Le=Jt=null,re=1,Po(!0),J!=et||nt!=Nt||x!=ht||F!=Lt){mr(!1);let v=x/ht,M=F/Lt;if(Zt&&!B&&pt.left>=0){pt.left*=v,pt.top*=M,vr&&zi(vr,an(pt.left),0,x,F),_r&&zi(_r,0,an(pt.top),x,F);for(let R=0;R<In.length;R++){let L=In[R];L!=null&&(Yi[R]*=
v,vi[R]*=M,zi(L,ui(Yi[R]),ui(vi[R]),x,F))}}if(We.show&&!ut&&We.left>=0&&We.width>0){We.left*=v,We.width*=v,We.top*=M,We.height*=M;for(let R in bh)qe(Mr,R,We[R])}et=J,Nt=nt,ht=x,Lt=F}mn("setSize"),yt=!1}Ee>0&&P>0&&(u.clearRect(0,0,h.width,h.height),mn("drawClear"),N.forEach(v=>v()),mn("draw")),We.show&&ut&&(Da(We),ut=!1),Zt&&B&&(ks(null,!0,!1),B=!1),xt.show&&xt.live&&dt&&(yh(),dt=!1),c||(c=!0,n.status=
1,mn("ready")),H=!1,La=!1}n.redraw=(v,M)=>{te=M||!1,v!==!1?gs(A,C.min,C.max):gr()};function vh(v,M){let R=y[v];if(R.from==null){if(on==0){let L=R.range(n,M.min,M.max,v);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(on>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;v==A&&R.distr==2&&on>0&&(M.min=wi(M.min,t[0]),M.max=wi(M.max,t[0]),M.min==M.max&&M.max++),X[v]=M,kt=!0,
gr()}}n.setScale=vh;let _h,xh,vr,_r,Bf,kf,xr,yr,zf,Vf,Ge,$e,ms=!1,Mn=pt.drag,dn=Mn.x,pn=Mn.y;Zt&&(pt.x&&(_h=hi(Ev,g)),pt.y&&(xh=hi(Tv,g)),C.ori==0?(vr=_h,_r=xh):(vr=xh,_r=_h),Ge=pt.left,$e=pt.top);let We=n.select=sn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Mr=We.show?hi(wv,We.over?g:d):null;function Da(v,M){if(We.show){for(let R in v)We[R]=v[R],R in bh&&qe(Mr,R,v[R]);M!==!1&&mn("s\
etSelect")}}n.setSelect=Da;function F0(v){if(b[v].show)ee&&qh(_t[v],Ws);else if(ee&&Qn(_t[v],Ws),Zt){let R=Ui?In[0]:In[v];R!=null&&zi(R,-10,-10,x,F)}}function gs(v,M,R){vh(v,{min:M,max:R})}function Ni(v,M,R,L){M.focus!=null&&z0(v),M.show!=null&&b.forEach((k,Y)=>{Y>0&&(v==Y||v==null)&&(k.show=M.show,F0(Y),s==2?(gs(k.facets[0].scale,null,null),gs(k.facets[1].scale,null,null)):gs(k.scale,null,null),gr())}),
R!==!1&&mn("setSeries",v,M),L&&Io("setSeries",n,v,M)}n.setSeries=Ni;function N0(v,M){sn(I[v],M)}function O0(v,M){v.fill=pe(v.fill||null),v.dir=we(v.dir,-1),M=M??I.length,I.splice(M,0,v)}function B0(v){v==null?I.length=0:I.splice(v,1)}n.addBand=O0,n.setBand=N0,n.delBand=B0;function k0(v,M){b[v].alpha=M,Zt&&In[v]!=null&&(In[v].style.opacity=M),ee&&_t[v]&&(_t[v].style.opacity=M)}let Zi,vs,Bs,br={focus:!0};
function z0(v){if(v!=Bs){let M=v==null,R=$n.alpha!=1;b.forEach((L,k)=>{if(s==1||k>0){let Y=M||k==0||k==v;L._focus=M?null:Y,R&&k0(k,Y?1:$n.alpha)}}),Bs=v,R&&gr()}}ee&&Vn&&Xt(Vd,tt,v=>{pt._lock||(yn(v),Bs!=null&&Ni(null,br,!0,nn.setSeries))});function Oi(v,M,R){let L=y[M];R&&(v=v/Ce-(L.ori==1?nt:J));let k=x;L.ori==1&&(k=F,v=k-v),L.dir==-1&&(v=k-v);let Y=L._min,it=L._max,lt=v/k,mt=Y+(it-Y)*lt,Et=L.distr;
return Et==3?Dr(10,mt):Et==4?Gv(mt,L.asinh):Et==100?L.bwd(mt):mt}function V0(v,M){let R=Oi(v,A,M);return wi(R,t[0],E,V)}n.valToIdx=v=>wi(v,t[0]),n.posToIdx=V0,n.posToVal=Oi,n.valToPos=(v,M,R)=>y[M].ori==0?r(v,y[M],R?gt:x,R?At:0):o(v,y[M],R?zt:F,R?at:0),n.setCursor=(v,M,R)=>{Ge=v.left,$e=v.top,ks(null,M,R)};function Hf(v,M){qe(Mr,Pr,We.left=v),qe(Mr,Oo,We.width=M)}function Gf(v,M){qe(Mr,"top",We.top=
v),qe(Mr,Bo,We.height=M)}let Co=C.ori==0?Hf:Gf,Ro=C.ori==1?Hf:Gf;function H0(){if(ee&&xt.live)for(let v=s==2?1:0;v<b.length;v++){if(v==0&&U)continue;let M=xt.values[v],R=0;for(let L in M)Qt[v][R++].firstChild.nodeValue=M[L]}}function yh(v,M){if(v!=null&&(v.idxs?v.idxs.forEach((R,L)=>{vt[L]=R}):Yv(v.idx)||vt.fill(v.idx),xt.idx=vt[0]),ee&&xt.live){for(let R=0;R<b.length;R++)(R>0||s==1&&!U)&&G0(R,vt[R]);
H0()}dt=!1,M!==!1&&mn("setLegend")}n.setLegend=yh;function G0(v,M){let R=b[v],L=v==0&&O==2?$:t[v],k;U?k=R.values(n,v,M)??xe:(k=R.value(n,M==null?null:L[M],v,M),k=k==null?xe:{_:k}),xt.values[v]=k}function ks(v,M,R){zf=Ge,Vf=$e,[Ge,$e]=pt.move(n,Ge,$e),pt.left=Ge,pt.top=$e,Zt&&(vr&&zi(vr,an(Ge),0,x,F),_r&&zi(_r,0,an($e),x,F));let L,k=E>V;Zi=Oe,vs=null;let Y=C.ori==0?x:F,it=C.ori==1?x:F;if(Ge<0||on==
0||k){L=pt.idx=null;for(let lt=0;lt<b.length;lt++){let mt=In[lt];mt!=null&&zi(mt,-10,-10,x,F)}Vn&&Ni(null,br,!0,v==null&&nn.setSeries),xt.live&&(vt.fill(L),dt=!0)}else{let lt,mt,Et;s==1&&(lt=C.ori==0?Ge:$e,mt=Oi(lt,A),L=pt.idx=wi(mt,t[0],E,V),Et=z(t[0][L],C,Y,0));let Ct=-10,Ut=-10,ie=0,Te=0,Se=!0,he="",jt="";for(let Wt=s==2?1:0;Wt<b.length;Wt++){let Xe=b[Wt],Qe=vt[Wt],gn=Qe==null?null:s==1?t[Wt][Qe]:
t[Wt][1][Qe],Fe=pt.dataIdx(n,Wt,L,mt),tn=Fe==null?null:s==1?t[Wt][Fe]:t[Wt][1][Fe];if(dt=dt||tn!=gn||Fe!=Qe,vt[Wt]=Fe,Wt>0&&Xe.show){let Zn=Fe==null?-10:Fe==L?Et:z(s==1?t[0][Fe]:t[Wt][0][Fe],C,Y,0),Un=tn==null?-10:G(tn,s==1?y[Xe.scale]:y[Xe.facets[1].scale],it,0);if(Vn&&tn!=null){let ai=C.ori==1?Ge:$e,_i=ln($n.dist(n,Wt,Fe,Un,ai));if(_i<Zi){let Bi=$n.bias;if(Bi!=0){let Jn=Oi(ai,Xe.scale),li=tn>=0?
1:-1,xi=Jn>=0?1:-1;xi==li&&(xi==1?Bi==1?tn>=Jn:tn<=Jn:Bi==1?tn<=Jn:tn>=Jn)&&(Zi=_i,vs=Wt)}else Zi=_i,vs=Wt}}if(dt||Ui){let ai,_i;C.ori==0?(ai=Zn,_i=Un):(ai=Un,_i=Zn);let Bi,Jn,li,xi,ki,Fn,Kn=!0,zs=Ne.bbox;if(zs!=null){Kn=!1;let Nn=zs(n,Wt);li=Nn.left,xi=Nn.top,Bi=Nn.width,Jn=Nn.height}else li=ai,xi=_i,Bi=Jn=Ne.size(n,Wt);if(Fn=Ne.fill(n,Wt),ki=Ne.stroke(n,Wt),Ui)Wt==vs&&Zi<=$n.prox&&(Ct=li,Ut=xi,ie=
Bi,Te=Jn,Se=Kn,he=Fn,jt=ki);else{let Nn=In[Wt];Nn!=null&&(Yi[Wt]=li,vi[Wt]=xi,$d(Nn,Bi,Jn,Kn),qd(Nn,Fn,ki),zi(Nn,ui(li),ui(xi),x,F))}}}}if(Ui){let Wt=$n.prox,Xe=Bs==null?Zi<=Wt:Zi>Wt||vs!=Bs;if(dt||Xe){let Qe=In[0];Qe!=null&&(Yi[0]=Ct,vi[0]=Ut,$d(Qe,ie,Te,Se),qd(Qe,he,jt),zi(Qe,ui(Ct),ui(Ut),x,F))}}}if(We.show&&ms)if(v!=null){let[lt,mt]=nn.scales,[Et,Ct]=nn.match,[Ut,ie]=v.cursor.sync.scales,Te=v.
cursor.drag;if(dn=Te._x,pn=Te._y,dn||pn){let{left:Se,top:he,width:jt,height:Wt}=v.select,Xe=v.scales[Ut].ori,Qe=v.posToVal,gn,Fe,tn,Zn,Un,ai=lt!=null&&Et(lt,Ut),_i=mt!=null&&Ct(mt,ie);ai&&dn?(Xe==0?(gn=Se,Fe=jt):(gn=he,Fe=Wt),tn=y[lt],Zn=z(Qe(gn,Ut),tn,Y,0),Un=z(Qe(gn+Fe,Ut),tn,Y,0),Co(Ei(Zn,Un),ln(Un-Zn))):Co(0,Y),_i&&pn?(Xe==1?(gn=Se,Fe=jt):(gn=he,Fe=Wt),tn=y[mt],Zn=G(Qe(gn,ie),tn,it,0),Un=G(Qe(
gn+Fe,ie),tn,it,0),Ro(Ei(Zn,Un),ln(Un-Zn))):Ro(0,it)}else Sh()}else{let lt=ln(zf-Bf),mt=ln(Vf-kf);if(C.ori==1){let ie=lt;lt=mt,mt=ie}dn=Mn.x&&lt>=Mn.dist,pn=Mn.y&&mt>=Mn.dist;let Et=Mn.uni;Et!=null?dn&&pn&&(dn=lt>=Et,pn=mt>=Et,!dn&&!pn&&(mt>lt?pn=!0:dn=!0)):Mn.x&&Mn.y&&(dn||pn)&&(dn=pn=!0);let Ct,Ut;dn&&(C.ori==0?(Ct=xr,Ut=Ge):(Ct=yr,Ut=$e),Co(Ei(Ct,Ut),ln(Ut-Ct)),pn||Ro(0,it)),pn&&(C.ori==1?(Ct=xr,
Ut=Ge):(Ct=yr,Ut=$e),Ro(Ei(Ct,Ut),ln(Ut-Ct)),dn||Co(0,Y)),!dn&&!pn&&(Co(0,0),Ro(0,0))}if(Mn._x=dn,Mn._y=pn,v==null){if(R){if(td!=null){let[lt,mt]=nn.scales;nn.values[0]=lt!=null?Oi(C.ori==0?Ge:$e,lt):null,nn.values[1]=mt!=null?Oi(C.ori==1?Ge:$e,mt):null}Io(Bh,n,Ge,$e,x,F,L)}if(Vn){let lt=R&&nn.setSeries,mt=$n.prox;Bs==null?Zi<=mt&&Ni(vs,br,!0,lt):Zi>mt?Ni(null,br,!0,lt):vs!=Bs&&Ni(vs,br,!0,lt)}}dt&&
(xt.idx=L,yh()),M!==!1&&mn("setCursor")}let _s=null;Object.defineProperty(n,"rect",{get(){return _s==null&&Po(!1),_s}});function Po(v=!1){v?_s=null:(_s=g.getBoundingClientRect(),mn("syncRect",_s))}function Wf(v,M,R,L,k,Y,it){pt._lock||ms&&v!=null&&v.movementX==0&&v.movementY==0||(Mh(v,M,R,L,k,Y,it,!1,v!=null),v!=null?ks(null,!0,!0):ks(M,!0,!1))}function Mh(v,M,R,L,k,Y,it,lt,mt){if(_s==null&&Po(!1),
yn(v),v!=null)R=v.clientX-_s.left,L=v.clientY-_s.top;else{if(R<0||L<0){Ge=-10,$e=-10;return}let[Et,Ct]=nn.scales,Ut=M.cursor.sync,[ie,Te]=Ut.values,[Se,he]=Ut.scales,[jt,Wt]=nn.match,Xe=M.axes[0].side%2==1,Qe=C.ori==0?x:F,gn=C.ori==1?x:F,Fe=Xe?Y:k,tn=Xe?k:Y,Zn=Xe?L:R,Un=Xe?R:L;if(Se!=null?R=jt(Et,Se)?a(ie,y[Et],Qe,0):-10:R=Qe*(Zn/Fe),he!=null?L=Wt(Ct,he)?a(Te,y[Ct],gn,0):-10:L=gn*(Un/tn),C.ori==1){
let ai=R;R=L,L=ai}}mt&&(M==null||M.cursor.event.type==Bh)&&((R<=1||R>=x-1)&&(R=Hs(R,x)),(L<=1||L>=F-1)&&(L=Hs(L,F))),lt?(Bf=R,kf=L,[xr,yr]=pt.move(n,R,L)):(Ge=R,$e=L)}let bh={width:0,height:0,left:0,top:0};function Sh(){Da(bh,!1)}let Xf,qf,Yf,$f;function Zf(v,M,R,L,k,Y,it){ms=!0,dn=pn=Mn._x=Mn._y=!1,Mh(v,M,R,L,k,Y,it,!0,!1),v!=null&&(Xt(kh,Wh,Jf,!1),Io(kd,n,xr,yr,x,F,null));let{left:lt,top:mt,width:Et,
height:Ct}=We;Xf=lt,qf=mt,Yf=Et,$f=Ct}function Jf(v,M,R,L,k,Y,it){ms=Mn._x=Mn._y=!1,Mh(v,M,R,L,k,Y,it,!1,!0);let{left:lt,top:mt,width:Et,height:Ct}=We,Ut=Et>0||Ct>0,ie=Xf!=lt||qf!=mt||Yf!=Et||$f!=Ct;if(Ut&&ie&&Da(We),Mn.setScale&&Ut&&ie){let Te=lt,Se=Et,he=mt,jt=Ct;if(C.ori==1&&(Te=mt,Se=Ct,he=lt,jt=Et),dn&&gs(A,Oi(Te,A),Oi(Te+Se,A)),pn)for(let Wt in y){let Xe=y[Wt];Wt!=A&&Xe.from==null&&Xe.min!=Oe&&
gs(Wt,Oi(he+jt,Wt),Oi(he,Wt))}Sh()}else pt.lock&&(pt._lock=!pt._lock,ks(M,!0,v!=null));v!=null&&(He(kh,Wh),Io(kh,n,Ge,$e,x,F,null))}function W0(v,M,R,L,k,Y,it){if(pt._lock)return;yn(v);let lt=ms;if(ms){let mt=!0,Et=!0,Ct=10,Ut,ie;C.ori==0?(Ut=dn,ie=pn):(Ut=pn,ie=dn),Ut&&ie&&(mt=Ge<=Ct||Ge>=x-Ct,Et=$e<=Ct||$e>=F-Ct),Ut&&mt&&(Ge=Ge<xr?0:x),ie&&Et&&($e=$e<yr?0:F),ks(null,!0,!0),ms=!1}Ge=-10,$e=-10,vt.
fill(null),ks(null,!0,!0),lt&&(ms=lt)}function Kf(v,M,R,L,k,Y,it){pt._lock||(yn(v),bt(),Sh(),v!=null&&Io(Hd,n,Ge,$e,x,F,null))}function jf(){T.forEach(cx),It(n.width,n.height,!0)}Xs(Ya,Lr,jf);let Sr={};Sr.mousedown=Zf,Sr.mousemove=Wf,Sr.mouseup=Jf,Sr.dblclick=Kf,Sr.setSeries=(v,M,R,L)=>{let k=nn.match[2];R=k(n,M,R),R!=-1&&Ni(R,L,!0,!1)},Zt&&(Xt(kd,g,Zf),Xt(Bh,g,Wf),Xt(zd,g,v=>{yn(v),Po(!1)}),Xt(Vd,
g,W0),Xt(Hd,g,Kf),jh.add(n),n.syncRect=Po);let Ua=n.hooks=i.hooks||{};function mn(v,M,R){gh?Ao.push([v,M,R]):v in Ua&&Ua[v].forEach(L=>{L.call(null,n,M,R)})}(i.plugins||[]).forEach(v=>{for(let M in v.hooks)Ua[M]=(Ua[M]||[]).concat(v.hooks[M])});let Qf=(v,M,R)=>R,nn=sn({key:null,setSeries:!1,filters:{pub:Qd,sub:Qd},scales:[A,b[1]?b[1].scale:null],match:[tp,tp,Qf],values:[null,null]},pt.sync);nn.match.
length==2&&nn.match.push(Qf),pt.sync=nn;let td=nn.key,wh=Jp(td);function Io(v,M,R,L,k,Y,it){nn.filters.pub(v,M,R,L,k,Y,it)&&wh.pub(v,M,R,L,k,Y,it)}wh.sub(n);function X0(v,M,R,L,k,Y,it){nn.filters.sub(v,M,R,L,k,Y,it)&&Sr[v](null,M,R,L,k,Y,it)}n.pub=X0;function q0(){wh.unsub(n),jh.delete(n),Pt.clear(),Yh(Ya,Lr,jf),l.remove(),tt?.remove(),mn("destroy")}n.destroy=q0;function Eh(){mn("init",i,t),ft(t||
i.data,!1),X[A]?vh(A,X[A]):bt(),ut=We.show&&(We.width>0||We.height>0),B=dt=!0,It(i.width,i.height)}return b.forEach(Fs),T.forEach(ph),e?e instanceof HTMLElement?(e.appendChild(l),Eh()):e(n,Eh):Eh(),n}_n.assign=sn;_n.fmtNum=ru;_n.rangeNum=$a;_n.rangeLog=Ka;_n.rangeAsinh=iu;_n.orient=Ys;_n.pxRatio=Ce;_n.join=t_;_n.fmtDate=au,_n.tzDate=u_;_n.sync=Jp;{_n.addGap=Y_,_n.clipGaps=tl;let i=_n.paths={points:nm};
i.linear=sm,i.stepped=J_,i.bars=K_,i.spline=Q_}function cm(i){let t=[],e=n=>n.includes(".")?n.slice(0,n.lastIndexOf(".")):n;for(let n of i){let s=n.unit&&t.find(r=>r.unit===n.unit&&e(r.curves[0].name)===e(n.name)&&r.curves.length<Ar.length);s?s.curves.push(n):t.push({unit:n.unit,curves:[n]})}return t}var hx="11px system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",lm=i=>se.dark?Je(Ar[i%Ar.length],.25):Ar[i%Ar.length];function ux(i){
let t=n=>Array.from(n,s=>Number.isFinite(s)?i.log?s>0?s:null:s:null);return i.curves.every(n=>n.t===i.curves[0].t)?[Array.from(i.curves[0].t),...i.curves.map(n=>t(n.y))]:_n.join(i.curves.map(n=>[Array.from(n.t),t(n.y)]))}var Go=class{constructor(t,e,n,s,r){this.box=t;this.panels=e;this.begin=n;this.end=s;this.seek=r;this.shown=[];this.zoomed=null;this.syncing=!1;this.t=0}rebuild(){for(let e of this.
shown)e.plot.destroy();this.shown=[],this.box.replaceChildren();let t=this.box.clientWidth;if(t){for(let e of this.panels)this.shown.push(this.add(e,t));this.zoomed&&this.zoom(...this.zoomed),this.draw(this.t)}}get built(){return this.shown.length>0}resize(){let t=this.box.clientWidth;if(t){if(!this.built){this.rebuild();return}for(let e of this.shown)e.plot.setSize({width:t,height:e.plot.height});
this.draw(this.t)}}add(t,e){let n=document.createElement("div"),s=document.createElement("div");if(n.className="plot",s.className="names",t.title){let c=document.createElement("b");c.textContent=t.title,s.append(c)}let r=t.curves.map((c,l)=>{let h=document.createElement("span"),u=document.createElement("em");return h.textContent=c.name,h.style.color=lm(l),h.title="show or hide",h.onclick=()=>{let f=!o.
series[l+1].show;o.setSeries(l+1,{show:f}),h.classList.toggle("off",!f)},h.append(u),s.append(h),u});if(t.unit){let c=document.createElement("small");c.textContent=`[${t.unit}]`,s.append(c)}n.append(s),this.box.append(n);let o=new _n(this.options(t,e),ux(t),n),a=document.createElement("div");return a.className="now",o.over.append(a),{plot:o,panel:t,values:r,line:a}}options(t,e){let n={font:hx,stroke:se.
soft,grid:{stroke:se.grid,width:1},ticks:{show:!1}},s=r=>r===null?"":Bn(r);return{width:e,height:t.height??138,padding:[6,14,0,0],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{x:!0,y:!1,dist:6},bind:{dblclick:()=>()=>(this.zoom(this.begin,this.end),null)}},scales:{x:{time:!1,min:this.begin,max:this.end>this.begin?this.end:this.begin+1},y:t.log?{distr:3}:{range:(r,o,a)=>fx(o,a)}},axes:[{...n,
size:26,gap:4,values:(r,o)=>o.map(s)},{...n,size:58,gap:4,values:(r,o)=>o.map(s),space:t.log?18:24}],series:[{},...t.curves.map((r,o)=>({stroke:lm(o),width:1.5,spanGaps:!0,points:{show:!1},dash:r.dashed?[5,4]:void 0}))],hooks:{setScale:[(r,o)=>{o!=="x"||this.syncing||r.scales.x.min==null||r.scales.x.max==null||this.shown.length&&this.zoom(r.scales.x.min,r.scales.x.max)}],ready:[r=>{r.over.addEventListener(
"click",o=>{r.select.width>0||this.seek(Gn(r.posToVal(o.offsetX,"x"),this.begin,this.end))})}]}}}zoom(t,e){this.syncing=!0,this.zoomed=t<=this.begin&&e>=this.end?null:[t,e];for(let{plot:n}of this.shown)n.setScale("x",{min:t,max:e}),n.setSelect({left:0,top:0,width:0,height:0},!1);this.syncing=!1,this.draw(this.t),this.box.classList.toggle("zoomed",this.zoomed!==null)}draw(t){this.t=t;for(let{plot:e,
panel:n,values:s,line:r}of this.shown){let o=e.valToPos(t,"x");r.hidden=!(o>=-1&&o<=e.over.clientWidth+1),r.style.transform=`translateX(${Math.round(o)}px)`,n.curves.forEach((a,c)=>{s[c].textContent=Bn(a.t.length?a.y[Er(a.t,t)]:NaN)})}}};function fx(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(Math.abs(i),Math.abs(t));if(t-i<=1e-9*e||t===i)return e===
0?[-1,1]:[i-.1*e,t+.1*e];let n=.07*(t-i);return[i-n,t+n]}function rl(i,t,e){if(t.isPlanar)return ol(i);let n=On([-.45,.65,.62]),s=[Ht(e,t.right),Ht(e,t.up),Ht(e,t.toward)];return Je(i,-.22+.6*Math.max(0,Ht(s,n)))}var ol=i=>Je(i,se.dark?-.12:.3),al=i=>Je(i,se.dark?.3:-.38);function Ke(i,t=!0){let e=new Path2D;return i.forEach((n,s)=>s?e.lineTo(n[0],n[1]):e.moveTo(n[0],n[1])),t&&e.closePath(),e}function um(i){let t=i.slice().sort((n,s)=>n[0]-s[0]||n[1]-s[1]),
e=n=>{let s=[];for(let r of n){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return e(t).concat(e(t.reverse()))}function zr(i,t,e,n){i.fillStyle=e,i.fill(t),i.strokeStyle=al(n),i.lineWidth=1.3,i.lineJoin="round",i.stroke(t)}function ll(i,t,e,n,s=40){return Array.from({length:s},(r,o)=>{let a=2*Math.PI*o/s;return Rt(
i,Rt(Tt(t,n*Math.cos(a)),Tt(e,n*Math.sin(a))))})}var cl=[[1,0,0],[0,1,0],[0,0,1]];function dx(i,t){let e=t.r,n=i.radius??0;return{centre:e,planes:[],least:s=>Ht(s,e)-n,points:()=>mu(e,[[n,0,0],[0,n,0],[0,0,n]]),paint(s,r,o){let[a,c]=r.project(e),l=Math.max(1.5,n*r.scale),h=new Path2D;h.arc(a,c,l,0,2*Math.PI);let u=ol(o);return r.isPlanar||(u=s.createRadialGradient(a-.35*l,c-.42*l,.05*l,a,c,l),u.addColorStop(
0,Je(o,.62)),u.addColorStop(.55,Je(o,.12)),u.addColorStop(1,Je(o,-.25))),zr(s,h,u,o),l>6&&bx(s,r,t,n,o),h}}}function px(i,t){let e=i.halfExtents??[0,0,0],n=cl.map(o=>vn(t.q,o)),s=n.map((o,a)=>Tt(o,e[a])),r=[];for(let o of[0,1,2])for(let a of[1,-1]){let c=Tt(n[o],a);r.push({n:c,o:Ht(c,t.r)+e[o],k:o,s:a})}return{centre:t.r,planes:r,least:o=>Ht(o,t.r)-s.reduce((a,c)=>a+Math.abs(Ht(o,c)),0),points:()=>mu(
t.r,s),paint(o,a,c){let l=new Path2D;for(let{n:h,k:u,s:f}of r){if(Ht(h,a.toward)<=.001)continue;let[d,g]=[s[(u+1)%3],s[(u+2)%3]],_=Rt(t.r,Tt(s[u],f)),m=[[1,1],[-1,1],[-1,-1],[1,-1]].map(([b,T])=>a.project(Rt(_,Rt(Tt(d,b),Tt(g,T))))),p=Ke(m);zr(o,p,rl(c,a,h),c),l.addPath(p)}return l}}}function mx(i,t){let e=vn(t.q,[0,0,i.halfLength??0]),n=i.radius??0,s=[ue(t.r,e),Rt(t.r,e)];return{centre:t.r,planes:[],
least:r=>Ht(r,t.r)-Math.abs(Ht(r,e))-n,points:()=>s.flatMap(r=>mu(r,[[n,0,0],[0,n,0],[0,0,n]])),paint(r,o,a){let c=n*o.scale,[l,h]=s.map(d=>o.project(d)),u=Math.atan2(h[1]-l[1],h[0]-l[0]),f=new Path2D;return f.arc(l[0],l[1],c,u+Math.PI/2,u-Math.PI/2),f.arc(h[0],h[1],c,u-Math.PI/2,u+Math.PI/2),f.closePath(),zr(r,f,pm(r,o,l,u,c,a),a),f}}}function gx(i,t){let[e,n,s]=cl.map(h=>vn(t.q,h)),r=i.radius??0,
o=i.halfLength??0,a=Tt(s,o),c=[ue(t.r,a),Rt(t.r,a)],l=c.map(h=>ll(h,e,n,r));return{centre:t.r,planes:[1,-1].map(h=>({n:Tt(s,h),o:h*Ht(s,t.r)+o})),least:h=>Ht(h,t.r)-Math.abs(Ht(h,a))-r*Math.hypot(Ht(h,e),Ht(h,n)),points:()=>l.flat(),paint(h,u,f){let d=l.map(T=>T.map(y=>u.project(y))),g=Ke(um(d.flat())),[_,m]=c.map(T=>u.project(T)),p=Math.atan2(m[1]-_[1],m[0]-_[0]);zr(h,g,pm(h,u,_,p,r*u.scale,f),f);
let b=Ht(s,u.toward);if(Math.abs(b)>.001){let T=b>0?1:0;zr(h,Ke(d[T]),rl(f,u,Tt(s,Math.sign(b))),f),mm(h,u,c[T],e,r,f)}return g}}}function fm(i,t,e){return{centre:e,planes:[],least:n=>Math.min(...i.map(s=>Ht(n,s))),points:()=>i,paint(n,s,r){let o=new Path2D,a=[];for(let c of t){let l=c.map(u=>i[u]),h=On(Ze(ue(l[1],l[0]),ue(l[2],l[0])));Ht(h,s.toward)>.001&&a.push({n:h,corners:l,depth:Ht(sl(l),s.toward)})}
a.sort((c,l)=>c.depth-l.depth);for(let{n:c,corners:l}of a){let h=Ke(l.map(u=>s.project(u)));n.fillStyle=n.strokeStyle=rl(r,s,c),n.lineWidth=.7,n.fill(h),n.stroke(h),o.addPath(h)}return o}}}function pu(i,t,e,n){let s=[],r=[];for(let o=0;o<=t;++o)for(let a=0;a<e;++a)s.push(Rt(i.r,vn(i.q,n(o/t,2*Math.PI*a/e))));for(let o=0;o<t;++o)for(let a=0;a<e;++a){let[c,l]=[o*e+a,o*e+(a+1)%e];r.push([c,l,l+e],[c,
l+e,c+e])}return fm(s,r,i.r)}function vx(i,t){let[e,n,s]=i.halfExtents??[0,0,0];return pu(t,14,28,(r,o)=>{let a=Math.sin(Math.PI*r);return[e*a*Math.cos(o),n*a*Math.sin(o),-s*Math.cos(Math.PI*r)]})}function _x(i,t){let e=i.radius??0,n=i.tube??0;return pu(t,14,40,(s,r)=>{let o=e-n*Math.cos(2*Math.PI*s);return[o*Math.cos(r),o*Math.sin(r),-n*Math.sin(2*Math.PI*s)]})}function xx(i,t){let e=i.radius??0,
n=2*(i.halfLength??0);return pu(t,2,40,(s,r)=>{let o=s===.5?e:0;return[o*Math.cos(r),o*Math.sin(r),s===1?n:0]})}function yx(i,t){let[e,n,s]=cl.map(c=>vn(t.q,c)),r=i.radius??0,o=dm(ll(t.r,e,n,r,64),t.r,s),a=o.paint;return o.paint=(c,l,h)=>{let u=a(c,l,h);return mm(c,l,t.r,e,r,h),u},o}var sl=i=>Tt(i.reduce(Rt,[0,0,0]),1/(i.length||1)),Wo={sphere:dx,box:px,capsule:mx,cylinder:gx,circle:yx,ellipsoid:vx,
torus:_x,cone:xx,mesh(i,t){let e=(i.points??[]).map(n=>Rt(t.r,vn(t.q,n)));return fm(e,i.triangles??[],sl(e))},polygon(i,t){let e=(i.points??[]).map(s=>Rt(t.r,vn(t.q,s))),n=e.length>2?On(Ze(ue(e[1],e[0]),ue(e[2],e[0]))):[0,0,1];return dm(e,sl(e),n)},segment:(i,t)=>hm((i.points??[]).map(e=>Rt(t.r,vn(t.q,e))),i),link(i,t,e){let[n,s]=i.points??[];return hm([Rt(t.r,vn(t.q,n??[0,0,0])),Rt(e.r,vn(e.q,s??
[0,0,0]))],i)}};function mu(i,[t,e,n]){let s=[];for(let r of[-1,1])for(let o of[-1,1])for(let a of[-1,1])s.push(Rt(i,Rt(Tt(t,r),Rt(Tt(e,o),Tt(n,a)))));return s}function dm(i,t,e){let n=Ht(e,t);return{centre:t,points:()=>i,planes:[{n:e,o:n},{n:Tt(e,-1),o:-n}],least:s=>Math.min(...i.map(r=>Ht(s,r))),paint(s,r,o){let a=Ke(i.map(c=>r.project(c)));return zr(s,a,rl(o,r,Ht(e,r.toward)<0?Tt(e,-1):e),o),a}}}
function hm(i,t){return{centre:sl(i),points:()=>i,planes:[],least:e=>Math.min(...i.map(n=>Ht(e,n))),paint(e,n,s){let r=i.map(l=>n.project(l)),o=t.radius??0,a=o>0?Math.max(1.5,2*o*n.scale):2.4;t.style==="spring"&&(r=Mx(r[0],r[r.length-1],8));let c=Ke(r,!1);return e.lineCap=e.lineJoin="round",e.setLineDash(t.style==="dashed"?[7,6]:[]),o>0&&t.style!=="spring"?(e.strokeStyle=al(s),e.lineWidth=a+2.6,e.
stroke(c),e.strokeStyle=ol(s)):e.strokeStyle=Je(s,se.dark?.25:-.2),e.lineWidth=t.style==="spring"?1.8:a,e.stroke(c),e.setLineDash([]),Ke(um(r.flatMap(([l,h])=>[[l-4,h-4],[l+4,h-4],[l,h+5]])))}}}function Mx(i,t,e){let n=[t[0]-i[0],t[1]-i[1]],s=Math.hypot(...n)||1,r=[-n[1]/s*e,n[0]/s*e],o=(c,l)=>[i[0]+n[0]*c+r[0]*l,i[1]+n[1]*c+r[1]*l],a=Array.from({length:24},(c,l)=>o(.1+.8*(l+.5)/24,l%2?1:-1));return[
i,o(.1,0),...a,o(.9,0),t]}function pm(i,t,e,n,s,r){if(t.isPlanar)return ol(r);let o=[Math.sin(n),-Math.cos(n)];o[0]*-.45+o[1]*-.65<0&&(o=[-o[0],-o[1]]);let a=i.createLinearGradient(e[0]+o[0]*s,e[1]+o[1]*s,e[0]-o[0]*s,e[1]-o[1]*s);return a.addColorStop(0,Je(r,.25)),a.addColorStop(.3,Je(r,.5)),a.addColorStop(1,Je(r,-.25)),a}function mm(i,t,e,n,s,r){let o=t.project(e),a=t.project(Rt(e,Tt(n,s)));i.strokeStyle=
i.fillStyle=al(r),i.lineWidth=1.3,i.stroke(Ke([o,a],!1)),i.beginPath(),i.arc(o[0],o[1],2.2,0,2*Math.PI),i.fill()}function bx(i,t,e,n,s){i.strokeStyle=al(s)+(t.isPlanar?"b0":"70"),i.lineWidth=1.1;let[r,o,a]=cl.map(c=>vn(e.q,c));for(let[c,l]of[[o,a],[r,o]]){let h=Ze(c,l),u=Ze(h,t.toward);if(Tn(u)<1e-6)continue;u=On(u);let f=Ze(u,h);Ht(f,t.toward)<0&&(f=Tt(f,-1));let d=Array.from({length:25},(g,_)=>{
let m=Math.PI*_/24;return t.project(Rt(e.r,Rt(Tt(u,n*Math.cos(m)),Tt(f,n*Math.sin(m)))))});i.stroke(Ke(d,!1))}}var hl=class{constructor(t,e){this.scene=t;this.film=e;this.bodies=t.shapes.filter(r=>r.kind in Wo&&r.colour!=="transparent");let n=t.shapes.filter(r=>r.kind==="halfspace");this.grounds=n.filter(r=>r.colour!=="transparent"),this.extent=this.measure();let s=n.length?this.plane(n[0],e.begin).n:[0,0,1];this.upAxis=Math.abs(s[1])>.9?1:2}shapePose(t,e){return fd(this.film.pose(t.frame,e),t.position,t.orientation)}plane(t,e){
let n=this.shapePose(t,e);return{c:n.r,n:vn(n.q,[0,0,1])}}pointsOf(t,e){let n=this.shapePose(t,e),s=t.radius??0;return t.kind==="sphere"&&this.bodies.length>300?[Rt(n.r,[s,s,s]),ue(n.r,[s,s,s])]:Wo[t.kind](t,n,this.film.pose(t.frameEnd??-1,e)).points()}instants(t,e){let n=Gn(Math.floor(3e3/Math.max(1,t)),2,e),{begin:s,end:r}=this.film;return Array.from({length:n},(o,a)=>s+(r-s)*a/(n-1))}measure(){
let t=[1/0,1/0,1/0],e=[-1/0,-1/0,-1/0],n=[],s=o=>{o.every(Number.isFinite)&&(n.push(o),o.forEach((a,c)=>{t[c]=Math.min(t[c],a),e[c]=Math.max(e[c],a)}))};for(let o of this.instants(this.bodies.length,60))for(let a of this.bodies)this.pointsOf(a,o).forEach(s);t[0]<=e[0]||(s([-1,-1,-1]),s([1,1,1]));let r=Math.max(Tn(ue(e,t)),1e-9);if(n.length>2e4){n=[];for(let o of[t[0],e[0]])for(let a of[t[1],e[1]])
for(let c of[t[2],e[2]])n.push([o,a,c])}for(let o of this.grounds){let{c:a,n:c}=this.plane(o,this.film.begin),l=Tt(Rt(t,e),.5),h=ue(l,Tt(c,Ht(c,ue(l,a))));Tn(ue(h,l))<1.5*r&&s(h)}return{lo:t,hi:e,points:n,size:Math.max(Tn(ue(e,t)),1e-9)}}pointsAround(t,e){let n=this.bodies.filter(r=>this.film.moves(r.frame)),s=[];for(let r of this.instants(n.length,40)){let o=ue(e,this.film.pose(t,r).r);for(let a of n)
for(let c of this.pointsOf(a,r))c.every(Number.isFinite)&&s.push(Rt(c,o))}return s.length?s:this.extent.points}naturalView(){if(this.scene.view)return this.scene.view;let{film:t}=this,e=(n,s)=>{for(let r=0;r<t.poses;++r)if(!t.stands(r,n)||s.some(o=>!t.stands(r,3+o,0)))return!1;return t.poses>0};return this.upAxis===1&&e(2,[1,2])?"xy":e(1,[1,3])?"xz":e(2,[1,2])?"xy":e(0,[2,3])?"yz":"iso"}};function gm(i){
let t=e=>{let n=1/0,s=-1/0;for(let r of i)n=Math.min(n,r[e]),s=Math.max(s,r[e]);return s-n};return Math.max(Tn([t(0),t(1),t(2)]),1e-9)}var vm={xy:{right:[1,0,0],up:[0,1,0],toward:[0,0,1]},xz:{right:[1,0,0],up:[0,0,1],toward:[0,-1,0]},yz:{right:[0,1,0],up:[0,0,1],toward:[1,0,0]}},gu=26*Math.PI/180,ul=class{constructor(){this.view="iso";this.upAxis=2;this.azimuth=-62*Math.PI/180;this.elevation=22*Math.PI/180;this.centre=[0,0,0];this.scale=100;this.width=1;this.height=1;this.perspective=!0;this.right=[1,0,0];this.up=[0,0,1];this.toward=
[0,-1,0];this.look()}get isPlanar(){return this.view in vm}get distance(){return this.height/(2*Math.tan(gu/2)*this.scale)}get hasDepth(){return this.perspective&&!this.isPlanar}look(){if(this.isPlanar){Object.assign(this,vm[this.view]);return}let[t,e]=[Math.cos(this.azimuth),Math.sin(this.azimuth)],[n,s]=[Math.cos(this.elevation),Math.sin(this.elevation)],r=o=>this.upAxis===2?o:this.upAxis===1?[o[1],
o[2],o[0]]:[o[2],o[0],o[1]];this.toward=r([n*t,n*e,s]),this.right=r([-e,t,0]),this.up=Ze(this.toward,this.right)}scaleAt(t){if(!this.hasDepth)return this.scale;let e=this.distance,n=e-Ht(ue(t,this.centre),this.toward);return n>.001*e?this.scale*e/n:0}project(t){let e=ue(t,this.centre),n=this.scaleAt(t);return n===0?[-1e6,-1e6]:[this.width/2+n*Ht(e,this.right),this.height/2-n*Ht(e,this.up)]}unproject(t,e){
return Rt(this.centre,Rt(Tt(this.right,(t-this.width/2)/this.scale),Tt(this.up,(this.height/2-e)/this.scale)))}depth(t){return Ht(ue(t,this.centre),this.toward)}orbit(t,e){this.azimuth-=t*.008,this.elevation=Gn(this.elevation+e*.008,-1.55,1.55),this.look()}pan(t,e){this.centre=Rt(this.centre,Rt(Tt(this.right,-t/this.scale),Tt(this.up,e/this.scale)))}zoom(t,e,n){let s=this.unproject(e,n);this.scale*=
t,this.centre=Rt(this.centre,ue(s,this.unproject(e,n)))}fit(t){let e=d=>{let g=1/0,_=-1/0;for(let m of d)g=Math.min(g,m),_=Math.max(_,m);return[g,_]},n=d=>e(t.map(g=>Ht(g,d))),[s,r,o]=[n(this.right),n(this.up),n(this.toward)],a=Math.max(s[1]-s[0],r[1]-r[0],1e-9),c=56,l=this.height>420?92:44,h=this.width*.84,u=Math.max(40,this.height-c-l),f=d=>(d[0]+d[1])/2;this.scale=Math.min(h/Math.max(s[1]-s[0],
a*.001),u/Math.max(r[1]-r[0],a*.001)),this.centre=Rt(Tt(this.right,f(s)),Rt(Tt(this.up,f(r)),Tt(this.toward,f(o))));for(let d=0;d<4;++d){let g=t.map(p=>this.project(p)),_=e(g.map(p=>p[0])),m=e(g.map(p=>p[1]));if(this.centre=this.unproject(f(_),f(m)-(c-l)/2),!this.hasDepth)break;this.scale*=Math.min(h/Math.max(_[1]-_[0],.001),u/Math.max(m[1]-m[0],.001),4)}}};var fl=class{constructor(t,e){this.canvas=t;this.scene=e;this.painted=[];this.ctx=t.getContext("2d"),this.colours=e.bodies.map(Cr)}recolour(){this.colours=this.scene.bodies.map(Cr)}resize(t,e,n){this.canvas.width=Math.round(t*n),this.canvas.height=Math.round(e*n)}draw(t,e,n){let{ctx:s,scene:r}=this,o=this.canvas.width/t.width;s.setTransform(o,0,0,o,0,0),s.fillStyle=se.paper,s.fillRect(0,0,t.width,
t.height),t.isPlanar&&Ex(s,t);let a=r.grounds.map(h=>r.plane(h,e)),c=h=>Ht(h.n,t.toward);a.sort((h,u)=>c(h)-c(u));for(let h of a)c(h)>=-.001&&xm(s,t,h,r);this.painted=[];let l=r.bodies.map((h,u)=>({item:Wo[h.kind](h,r.shapePose(h,e),r.film.pose(h.frameEnd??-1,e)),frame:h.frame,colour:this.colours[u],depth:0}));for(let{item:h,frame:u,colour:f}of Sx(l,t)){let d=h.paint(s,t,f);this.painted.push({path:d,
frame:u}),u>=0&&u===n&&(s.strokeStyle=se.accent,s.lineWidth=3,s.stroke(d))}for(let h of a)c(h)<-.001&&xm(s,t,h,r)}pick(t,e){this.ctx.setTransform(1,0,0,1,0,0);for(let n=this.painted.length-1;n>=0;--n)if(this.ctx.isPointInPath(this.painted[n].path,t,e))return this.painted[n].frame;return-2}};function Sx(i,t){for(let r of i)r.depth=t.depth(r.item.centre);if(i.sort((r,o)=>r.depth-o.depth),t.isPlanar||
i.length>200)return i;let e=[],n=new Set,s=r=>{if(!n.has(r)){n.add(r);for(let o of i)o!==r&&wx(o.item,r.item,t)&&s(o);e.push(r)}};return i.forEach(s),e}function wx(i,t,e){let n=(s,r)=>_m(s,r,e,1)||_m(r,s,e,-1);return n(i,t)&&!n(t,i)}function _m(i,t,e,n){return i.planes.some(({n:s,o:r})=>n*Ht(s,e.toward)>1e-6&&t.least(s)>=r-1e-9-1e-4*Math.abs(r))}function Ex(i,t){let e=t.unproject(0,t.height),n=t.unproject(
t.width,0),s=Vs(0,t.width/t.scale,Math.max(4,Math.round(t.width/90))).step;i.lineWidth=1;for(let[r,o]of[[t.right,!0],[t.up,!1]])for(let a=Math.ceil(Ht(e,r)/s);a*s<=Ht(n,r);++a){let c=Rt(t.centre,Tt(r,a*s-Ht(t.centre,r))),[l,h]=t.project(c).map(u=>Math.round(u)+.5);i.strokeStyle=a===0?se.gridZero:se.grid,i.beginPath(),o?(i.moveTo(l,0),i.lineTo(l,t.height)):(i.moveTo(0,h),i.lineTo(t.width,h)),i.stroke()}}
function xm(i,t,{c:e,n},s){let r=Ht(n,t.toward);if(Math.abs(r)<.02){Tx(i,t,e,n);return}if(t.isPlanar)return;let{lo:o,hi:a,size:c}=s.extent,l=On(Ze(Math.abs(n[0])<.9?[1,0,0]:[0,1,0],n)),h=Ze(n,l),u=Tt(Rt(o,a),.5),f=ue(u,Tt(n,Ht(n,ue(u,e)))),d=.75*c,g=Vs(0,2*d,12).step,_=Math.ceil(d/g),m=[l,h].map(T=>Math.round(Ht(f,T)/g)*g-Ht(f,T)),p=(T,y)=>t.project(Rt(f,Rt(Tt(l,m[0]+T*g),Tt(h,m[1]+y*g)))),b=Ke([p(
-_,-_),p(_,-_),p(_,_),p(-_,_)]);if(i.fillStyle=r>0?se.ground:se.sheet,i.fill(b),i.strokeStyle=se.groundLine,i.lineWidth=1,r<0){i.stroke(b);return}for(let T=-_;T<=_;++T)i.stroke(Ke([p(T,-_),p(T,_)],!1)),i.stroke(Ke([p(-_,T),p(_,T)],!1))}function Tx(i,t,e,n){let s=t.project(e),r=[Ht(n,t.right),-Ht(n,t.up)],o=[-r[1],r[0]],a=t.width+t.height,c=(t.width/2-s[0])*o[0]+(t.height/2-s[1])*o[1],l=Math.floor(
(c-a)/11),h=Math.ceil((c+a)/11),u=(f,d)=>[s[0]+o[0]*f-r[0]*d,s[1]+o[1]*f-r[1]*d];i.fillStyle=se.ground,i.fill(Ke([u(l*11,0),u(h*11,0),u(h*11,14),u(l*11,14)])),i.strokeStyle=se.hatch,i.lineWidth=1.1,i.beginPath();for(let f=l;f<=h;++f){let d=u(f*11+11,0),g=u(f*11,14);i.moveTo(d[0],d[1]),i.lineTo(g[0],g[1])}i.stroke(),i.strokeStyle=se.edge,i.lineWidth=1.8,i.stroke(Ke([u(l*11,0),u(h*11,0)],!1))}var ym="system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif",Ax=60,Cx=1500,dl=class{constructor(t,e){this.canvas=t;this.film=e;this.ctx=t.getContext("2d"),this.usualForce=e.usualForce()}resize(t,e,n){this.canvas.width=Math.round(t*n),this.canvas.height=Math.round(e*n)}draw(t,e,n,s,r){let{ctx:o}=this,a=this.canvas.width/t.width;o.setTransform(a,0,0,a,0,0),o.clearRect(0,0,t.width,t.height),
s.trails&&this.paintTrails(t,e),s.contacts&&this.paintContacts(t,e,n,r),Px(o,t)}paintTrails(t,e){let{film:n,ctx:s}=this,r=n.indexAt(e),o=Math.max(1,Math.ceil(r/600));s.lineWidth=1.4;for(let a=0;a<Math.min(n.poses,60);++a){if(!n.moves(a))continue;let c=[];for(let l=0;l<=r;l+=o)c.push(t.project(n.pose(a,n.t[l]).r));c.push(t.project(n.pose(a,e).r)),s.strokeStyle=Je(Uo[a%Uo.length],se.dark?0:.2),s.stroke(
Ke(c,!1))}}paintContacts(t,e,n,s){let{ctx:r}=this,o=this.film.contacts(e),a=this.usualForce>0?.1*s*n/this.usualForce:0,c=o.length<=Cx,l=.3*Math.min(t.width,t.height);if(o.length<=Ax)for(let f of o)this.paintCone(t,f,a,l);let h=bn.map(()=>new Path2D),u=bn.map(()=>new Path2D);for(let{r:f,F:d,state:g}of o){let _=bn[g]?g:0,m=t.project(f),p=Rx(m,t.project(Rt(f,Tt(d,a))),l);c?(u[_].moveTo(m[0]+3,m[1]),u[_].
arc(m[0],m[1],3,0,2*Math.PI),Math.hypot(p[0]-m[0],p[1]-m[1])>3&&Mm(h[_],u[_],m,p)):(h[_].moveTo(m[0],m[1]),h[_].lineTo(p[0],p[1]))}r.lineCap="butt",bn.forEach(({colour:f},d)=>{r.strokeStyle=r.fillStyle=se.dark?Je(f,.2):f,r.lineWidth=c?2.4:1.2,r.stroke(h[d]),r.fill(u[d])})}paintCone(t,e,n,s){let r=Ht(e.F,e.n);if(!(e.limit>0)||!(r>0)||e.limit>2*r)return;let{ctx:o}=this,a=(bn[e.state]??bn[0]).colour,
c=t.project(e.r),l=t.project(Rt(e.r,Tt(e.F,n))),h=Math.hypot(l[0]-c[0],l[1]-c[1]),u=n*(h>s?s/h:1),f=Rt(e.r,Tt(e.n,r*u)),d=Fa(e.n),g=Ze(e.n,d),_=ll(f,d,g,e.limit*u,36).map(T=>t.project(T));if(Math.hypot(_[0][0]-_[18][0],_[0][1]-_[18][1])+Math.hypot(_[9][0]-_[27][0],_[9][1]-_[27][1])<5)return;let m=[t.project(f)[0]-c[0],t.project(f)[1]-c[1]],p=T=>m[0]*(T[1]-c[1])-m[1]*(T[0]-c[0]),b=_.slice().sort((T,y)=>p(
T)-p(y));o.fillStyle=a+"24",o.fill(Ke([c,b[0],b[b.length-1]])),o.fill(Ke(_)),o.strokeStyle=a+"90",o.lineWidth=1.2,o.stroke(Ke(_)),o.stroke(Ke([b[0],c,b[b.length-1]],!1))}};function Rx(i,t,e){let n=Math.hypot(t[0]-i[0],t[1]-i[1]);return n>e?[i[0]+(t[0]-i[0])*e/n,i[1]+(t[1]-i[1])*e/n]:t}function Mm(i,t,e,n){let s=Math.atan2(n[1]-e[1],n[0]-e[0]),r=Math.min(11,.6*Math.hypot(n[0]-e[0],n[1]-e[1])),o=a=>[
n[0]-r*Math.cos(s+a),n[1]-r*Math.sin(s+a)];i.moveTo(e[0],e[1]),i.lineTo(n[0]-.8*r*Math.cos(s),n[1]-.8*r*Math.sin(s)),t.addPath(Ke([n,o(.42),o(-.42)]))}function Px(i,t){let e=t.height<420,n=[e?34:44,t.height-(e?34:44)],s=e?22:30,r=[["x",[1,0,0],"#c2413b"],["y",[0,1,0],"#3f8f46"],["z",[0,0,1],se.dark?"#5a93d6":"#2f6db5"]];r.sort((h,u)=>Ht(h[1],t.toward)-Ht(u[1],t.toward)),i.font=`600 13px ${ym}`,i.textAlign=
"center",i.textBaseline="middle";for(let[h,u,f]of r){let d=[Ht(u,t.right),-Ht(u,t.up)];if(Math.hypot(d[0],d[1])<.05)continue;i.strokeStyle=i.fillStyle=f,i.lineWidth=1.8;let g=new Path2D,_=new Path2D;Mm(g,_,n,[n[0]+d[0]*s,n[1]+d[1]*s]),i.stroke(g),i.fill(_),i.fillText(h,n[0]+d[0]*(s+10),n[1]+d[1]*(s+10))}let o=Vs(0,150/t.scale,2).step,a=o*t.scale,[c,l]=[n[0]+2*s+4,t.height-(e?24:30)];i.strokeStyle=
i.fillStyle=se.soft,i.lineWidth=1.4,i.stroke(Ke([[c,l-4],[c,l],[c+a,l],[c+a,l-4]],!1)),i.font=`12px ${ym}`,i.fillText(dd(o),c+a/2,l+11)}var Zm=0,Ku=1,Jm=2;var ju=1,fc=2,Xi=3,os=0,zn=1,mi=2,hs=0,tr=1,Qu=2,tf=3,ef=4,Km=5,Rs=100,jm=101,Qm=102,tg=103,eg=104,ng=200,ig=201,sg=202,rg=203,zl=204,Vl=205,og=206,ag=207,lg=208,cg=209,hg=210,ug=211,fg=212,dg=213,pg=214,dc=0,pc=1,mc=2,er=3,gc=4,vc=5,_c=6,xc=7,vo=0,mg=1,gg=2,us=0,vg=1,_g=2,xg=3,yg=4,Mg=5,bg=6,Sg=7;var nf=300,lr=301,cr=302,yc=303,Mc=304,Ma=306,Hl=1e3,Cs=1001,Gl=1002,qn=1003,wg=1004;var ba=1005;var Pi=1006,bc=1007;var Ls=1008;var Li=1009,sf=1010,rf=1011,_o=1012,Sc=1013,Ds=1014,Di=1015,xo=1016,wc=1017,Ec=1018,yo=1020,of=35902,af=35899,lf=1021,cf=1022,gi=1023,eo=1026,Mo=1027,Tc=1028,Ac=1029,hf=1030,Cc=1031;var Rc=1033,Sa=33776,wa=33777,Ea=33778,Ta=33779,Pc=35840,Ic=35841,Lc=35842,Dc=35843,Uc=36196,Fc=37492,Nc=37496,Oc=37808,Bc=37809,kc=37810,zc=37811,Vc=37812,Hc=37813,Gc=37814,Wc=37815,Xc=37816,qc=37817,Yc=37818,$c=37819,Zc=37820,Jc=37821,Kc=36492,jc=36494,Qc=36495,th=36283,eh=36284,nh=36285,ih=36286;var Qo=2300,Wl=2301,Bl=2302,Hu=2400,Gu=2401,Wu=2402;var Eg=3200,Tg=3201;var sh=0,Ag=1,fs="",si="srgb",nr="srgb-linear",ta="linear",De="srgb";var js=7680;var Xu=519,Cg=512,Rg=513,Pg=514,uf=515,Ig=516,Lg=517,Dg=518,Ug=519,qu=35044;var ff="300 es",Ri=2e3,ea=2001;var as=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){
let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},An=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c",
"2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c",
"7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc",
"cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var kl=Math.PI/180,Xl=180/Math.PI;function Aa(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(An[i&255]+An[i>>8&255]+An[i>>16&255]+An[i>>24&255]+"-"+An[t&255]+An[t>>8&255]+"-"+An[t>>16&15|64]+An[t>>24&255]+"-"+An[e&63|128]+An[e>>8&255]+"-"+An[e>>16&255]+An[e>>24&255]+An[n&255]+An[n>>8&255]+An[n>>16&255]+An[n>>24&255]).
toLowerCase()}function ve(i,t,e){return Math.max(t,Math.min(e,i))}function Ix(i,t){return(i%t+t)%t}function vu(i,t,e){return(1-e)*i+e*t}function Xo(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Wn(i,t){switch(t.constructor){case Float32Array:
return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var me=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error(
"index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){
return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.
x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){
let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.
y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.
lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,
this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*
s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},di=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],g=r[o+2],_=r[o+3];if(a===0){t[e+0]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u;return}
if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=_;return}if(u!==_||c!==f||l!==d||h!==g){let m=1-a,p=c*f+l*d+h*g+u*_,b=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){let I=Math.sqrt(T),A=Math.atan2(I,p*b);m=Math.sin(m*A)/I,a=Math.sin(a*A)/I}let y=a*b;if(c=c*m+f*y,l=l*m+d*y,h=h*m+g*y,u=u*m+_*y,m===1-a){let I=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=I,l*=I,h*=I,u*=I}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){
let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*u+c*d-l*f,t[e+1]=c*g+h*f+l*u-a*d,t[e+2]=l*g+h*d+a*f-c*u,t[e+3]=h*g-a*u-c*f-l*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){
this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),u=a(r/2),f=c(n/2),
d=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=f*h*u+l*d*g,this._y=l*d*u-f*h*g,this._z=l*h*g+f*d*u,this._w=l*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+l*d*g,this._y=l*d*u-f*h*g,this._z=l*h*g-f*d*u,this._w=l*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-l*d*g,this._y=l*d*u+f*h*g,this._z=l*h*g+f*d*u,this._w=l*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-l*d*g,this._y=l*d*u+f*h*g,this._z=l*h*g-f*d*u,this._w=l*h*u+
f*d*g;break;case"YZX":this._x=f*h*u+l*d*g,this._y=l*d*u+f*h*g,this._z=l*h*g-f*d*u,this._w=l*h*u-f*d*g;break;case"XZY":this._x=f*h*u-l*d*g,this._y=l*d*u-f*h*g,this._z=l*h*g+f*d*u,this._w=l*h*u+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=
t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-c)*d,this._y=(r-l)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-c)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+l)/d}else if(a>
u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-l)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(c+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+l)/d,this._y=(c+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=
n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=
-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*
t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){
if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let c=1-a*a;if(c<=Number.EPSILON){let d=1-e;return this._w=d*o+e*this._w,this._x=d*n+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this.
_z,this.normalize(),this}let l=Math.sqrt(c),h=Math.atan2(l,a),u=Math.sin((1-e)*h)/l,f=Math.sin(e*h)/l;return this._w=o*u+this._w*f,this._x=n*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.
set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(
e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.
z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:
throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.
z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){
return this.applyQuaternion(bm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(bm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/
(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).
applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(
1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),
this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){
return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(
this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.
y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return _u.copy(this).projectOnVector(t),this.sub(_u)}reflect(t){return this.sub(_u.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.
PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.
sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(
t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.
x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.
random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},_u=new W,bm=new di,oe=class i{constructor(t,e,n,s,r,o,a,c,l){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=
r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.
set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],f=n[2],d=n[5],g=n[8],_=s[0],m=s[3],p=s[6],b=s[1],T=s[4],y=s[7],I=s[2],A=s[5],D=s[8];return r[0]=o*_+a*b+c*I,r[3]=o*m+a*T+c*A,r[6]=o*p+
a*y+c*D,r[1]=l*_+h*b+u*I,r[4]=l*m+h*T+u*A,r[7]=l*p+h*y+u*D,r[2]=f*_+d*b+g*I,r[5]=f*m+d*T+g*A,r[8]=f*p+d*y+g*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,
e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,f=a*c-h*r,d=l*r-o*c,g=e*u+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return t[0]=u*_,t[1]=(s*l-h*n)*_,t[2]=(a*n-s*o)*_,t[3]=f*_,t[4]=(h*e-s*c)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(n*c-l*e)*_,t[8]=(o*e-n*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=
e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(
xu.makeScale(t,e)),this}rotate(t){return this.premultiply(xu.makeRotation(-t)),this}translate(t,e){return this.premultiply(xu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){
let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},xu=new oe;function df(i){
for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function na(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Fg(){let i=na("canvas");return i.style.display="block",i}var Sm={};function no(i){i in Sm||(Sm[i]=!0,console.warn(i))}function Ng(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:
n()}}setTimeout(r,e)})}var wm=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Em=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Lx(){let i={enabled:!0,workingColorSpace:nr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===De&&(s.r=rs(s.r),
s.g=rs(s.g),s.b=rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===De&&(s.r=to(s.r),s.g=to(s.g),s.b=to(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){
return this.spaces[s].primaries},getTransfer:function(s){return s===fs?ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){
return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return no("THREE.ColorManagement: .fromWorkingColorSpace() has b\
een renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return no("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[nr]:{primaries:t,whitePoint:n,transfer:ta,toXYZ:wm,fromXYZ:Em,luminanceCoefficients:e,
workingColorSpaceConfig:{unpackColorSpace:si},outputColorSpaceConfig:{drawingBufferColorSpace:si}},[si]:{primaries:t,whitePoint:n,transfer:De,toXYZ:wm,fromXYZ:Em,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:si}}}),i}var ye=Lx();function rs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function to(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-
.055}var Vr,ql=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Vr===void 0&&(Vr=na("canvas")),Vr.width=t.width,Vr.height=t.height;let s=Vr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Vr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<
"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=na("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=rs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.
data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(rs(e[n]/255)*255):e[n]=rs(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Dx=0,io=class{constructor(t=null){this.isSource=!0,Object.defineProperty(
this,"id",{value:Dx++}),this.uuid=Aa(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||
typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yu(s[o].image)):r.push(yu(s[o]))}else r=yu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function yu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||
typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ql.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Ux=0,Mu=new W,Yn=class i extends as{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Cs,s=Cs,r=Pi,o=Ls,a=gi,c=Li,l=i.
DEFAULT_ANISOTROPY,h=fs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ux++}),this.uuid=Aa(),this.name="",this.source=new io(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new me(0,0),this.repeat=new me(1,1),this.center=new me(0,0),this.rotation=
0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Mu).x}get height(){return this.
source.getSize(Mu).y}get depth(){return this.source.getSize(Mu).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.
constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),
this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,
this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||
s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.
x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};
return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==nf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Hl:t.x=t.x-Math.floor(t.x);break;case Cs:t.x=t.x<0?0:1;break;case Gl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(
t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Hl:t.y=t.y-Math.floor(t.y);break;case Cs:t.y=t.y<0?0:1;break;case Gl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Yn.DEFAULT_IMAGE=null;Yn.DEFAULT_MAPPING=
nf;Yn.DEFAULT_ANISOTROPY=1;var je=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.
y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of r\
ange: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.
x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=
t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*
Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],u=c[8],f=c[1],d=c[5],g=c[9],_=c[2],m=c[6],p=c[10];if(Math.abs(h-f)<.01&&Math.abs(u-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+_)<.1&&Math.abs(g+m)<.1&&Math.abs(l+d+p-3)<.1)return this.
set(1,0,0,0),this;e=Math.PI;let T=(l+1)/2,y=(d+1)/2,I=(p+1)/2,A=(h+f)/4,D=(u+_)/4,N=(g+m)/4;return T>y&&T>I?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=A/n,r=D/n):y>I?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=A/s,r=N/s):I<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),n=D/r,s=N/r),this.set(n,s,r,e),this}let b=Math.sqrt((m-g)*(m-g)+(u-_)*(u-_)+(f-h)*(f-h));return Math.
abs(b)<.001&&(b=1),this.x=(m-g)/b,this.y=(u-_)/b,this.z=(f-h)/b,this.w=Math.acos((l+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,
t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,
e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.
trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){
return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=
t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.
y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Yl=class extends as{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Pi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),
this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e);let s={width:t,height:e,depth:n.depth},r=new Yn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.
depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){let e={minFilter:Pi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&
(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==
void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){
return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,
e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.
assign({},t.textures[e].image);this.textures[e].source=new io(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Hi=class extends Yl{constructor(t=1,e=1,n={}){
super(t,e,n),this.isWebGLRenderTarget=!0}},ia=class extends Yn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=Cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var $l=class extends Yn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=Cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Gi=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ti.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ti.fromBufferAttribute(t,e));return this}setFromPoints(t){
this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ti.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){
return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(
t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,
o),Ti.applyMatrix4(t.matrixWorld),this.expandByPoint(Ti);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),pl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),pl.copy(n.boundingBox)),pl.applyMatrix4(t.matrixWorld),this.union(pl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&
t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){
return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ti),Ti.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=
t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qo),ml.subVectors(this.max,qo),Hr.subVectors(t.a,qo),Gr.subVectors(t.b,qo),Wr.subVectors(
t.c,qo),bs.subVectors(Gr,Hr),Ss.subVectors(Wr,Gr),$s.subVectors(Hr,Wr);let e=[0,-bs.z,bs.y,0,-Ss.z,Ss.y,0,-$s.z,$s.y,bs.z,0,-bs.x,Ss.z,0,-Ss.x,$s.z,0,-$s.x,-bs.y,bs.x,0,-Ss.y,Ss.x,0,-$s.y,$s.x,0];return!bu(e,Hr,Gr,Wr,ml)||(e=[1,0,0,0,1,0,0,0,1],!bu(e,Hr,Gr,Wr,ml))?!1:(gl.crossVectors(bs,Ss),e=[gl.x,gl.y,gl.z],bu(e,Hr,Gr,Wr,ml))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){
return this.clampPoint(t,Ti).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ti).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Qi[0].set(this.min.x,this.min.
y,this.min.z).applyMatrix4(t),Qi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Qi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Qi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Qi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Qi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Qi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Qi[7].set(
this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Qi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Qi=[new W,new W,new W,new W,new W,new W,new W,new W],Ti=new W,
pl=new Gi,Hr=new W,Gr=new W,Wr=new W,bs=new W,Ss=new W,$s=new W,qo=new W,ml=new W,gl=new W,Zs=new W;function bu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Zs.fromArray(i,r);let a=s.x*Math.abs(Zs.x)+s.y*Math.abs(Zs.y)+s.z*Math.abs(Zs.z),c=t.dot(Zs),l=e.dot(Zs),h=n.dot(Zs);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Fx=new Gi,Yo=new W,Su=new W,ls=class{constructor(t=new W,e=-1){
this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Fx.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<
0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(
this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*
t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yo.subVectors(t,this.center);let e=Yo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Yo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):
(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Su.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yo.copy(t.center).add(Su)),this.expandByPoint(Yo.copy(t.center).sub(Su))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.
center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},ts=new W,wu=new W,vl=new W,ws=new W,Eu=new W,_l=new W,Tu=new W,so=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(
this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ts)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(
t))}distanceSqToPoint(t){let e=ts.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ts.copy(this.origin).addScaledVector(this.direction,e),ts.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){wu.copy(t).add(e).multiplyScalar(.5),vl.copy(e).sub(t).normalize(),ws.copy(this.origin).sub(wu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(vl),a=ws.dot(this.direction),
c=-ws.dot(vl),l=ws.lengthSq(),h=Math.abs(1-o*o),u,f,d,g;if(h>0)if(u=o*c-a,f=o*a-c,g=r*h,u>=0)if(f>=-g)if(f<=g){let _=1/h;u*=_,f*=_,d=u*(u+o*f+2*a)+f*(o*u+f+2*c)+l}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*c)+l;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*c)+l;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-c),r),d=-u*u+f*(f+2*c)+l):f<=g?(u=0,f=Math.min(Math.max(-r,-c),r),d=
f*(f+2*c)+l):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-c),r),d=-u*u+f*(f+2*c)+l);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(wu).addScaledVector(vl,f),d}intersectSphere(t,e){ts.subVectors(t.center,this.origin);let n=ts.dot(this.direction),s=ts.dot(ts)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.
sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===
null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return l>=0?(n=(t.min.x-f.x)*l,s=(t.max.x-f.x)*l):(n=(t.max.x-f.x)*l,s=(t.min.x-f.x)*l),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.
y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,c=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,c=(t.min.z-f.z)*u),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ts)!==null}intersectTriangle(t,e,n,s,r){Eu.subVectors(e,t),_l.subVectors(n,t),Tu.crossVectors(Eu,_l);let o=this.direction.dot(Tu),
a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ws.subVectors(this.origin,t);let c=a*this.direction.dot(_l.crossVectors(ws,_l));if(c<0)return null;let l=a*this.direction.dot(Eu.cross(ws));if(l<0||c+l>o)return null;let h=-a*ws.dot(Tu);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.
equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ge=class i{constructor(t,e,n,s,r,o,a,c,l,h,u,f,d,g,_,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,h,u,f,d,g,_,m)}set(t,e,n,s,r,o,a,c,l,h,u,f,d,g,_,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=
a,p[13]=c,p[2]=l,p[6]=h,p[10]=u,p[14]=f,p[3]=d,p[7]=g,p[11]=_,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=
n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,
n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Xr.setFromMatrixColumn(t,0).length(),r=1/Xr.setFromMatrixColumn(t,1).length(),o=1/Xr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){
let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,g=a*h,_=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=d+g*l,e[5]=f-_*l,e[9]=-a*c,e[2]=_-f*l,e[6]=g+d*l,e[10]=o*c}else if(t.order==="YXZ"){let f=c*h,d=c*u,g=l*h,_=l*u;e[0]=f+_*a,e[4]=g*a-d,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=_+f*a,e[10]=o*
c}else if(t.order==="ZXY"){let f=c*h,d=c*u,g=l*h,_=l*u;e[0]=f-_*a,e[4]=-o*u,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=_-f*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let f=o*h,d=o*u,g=a*h,_=a*u;e[0]=c*h,e[4]=g*l-d,e[8]=f*l+_,e[1]=c*u,e[5]=_*l+f,e[9]=d*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let f=o*c,d=o*l,g=a*c,_=a*l;e[0]=c*h,e[4]=_-f*u,e[8]=g*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=
-l*h,e[6]=d*u+g,e[10]=f-_*u}else if(t.order==="XZY"){let f=o*c,d=o*l,g=a*c,_=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=f*u+_,e[5]=o*h,e[9]=d*u-g,e[2]=g*u-d,e[6]=a*h,e[10]=_*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Nx,t,Ox)}lookAt(t,e,n){let s=this.elements;return ni.subVectors(t,e),ni.lengthSq()===0&&(ni.z=1),ni.normalize(),Es.
crossVectors(n,ni),Es.lengthSq()===0&&(Math.abs(n.z)===1?ni.x+=1e-4:ni.z+=1e-4,ni.normalize(),Es.crossVectors(n,ni)),Es.normalize(),xl.crossVectors(ni,Es),s[0]=Es.x,s[4]=xl.x,s[8]=ni.x,s[1]=Es.y,s[5]=xl.y,s[9]=ni.y,s[2]=Es.z,s[6]=xl.z,s[10]=ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,
r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],f=n[9],d=n[13],g=n[2],_=n[6],m=n[10],p=n[14],b=n[3],T=n[7],y=n[11],I=n[15],A=s[0],D=s[4],N=s[8],w=s[12],S=s[1],C=s[5],O=s[9],z=s[13],G=s[2],X=s[6],q=s[10],Z=s[14],j=s[3],rt=s[7],ot=s[11],vt=s[15];return r[0]=o*A+a*S+c*G+l*j,r[4]=o*D+a*C+c*X+l*rt,r[8]=o*N+a*O+c*q+l*ot,r[12]=o*w+a*z+c*Z+l*vt,r[1]=h*A+u*S+f*G+d*j,r[5]=h*D+u*C+f*X+d*rt,r[9]=h*
N+u*O+f*q+d*ot,r[13]=h*w+u*z+f*Z+d*vt,r[2]=g*A+_*S+m*G+p*j,r[6]=g*D+_*C+m*X+p*rt,r[10]=g*N+_*O+m*q+p*ot,r[14]=g*w+_*z+m*Z+p*vt,r[3]=b*A+T*S+y*G+I*j,r[7]=b*D+T*C+y*X+I*rt,r[11]=b*N+T*O+y*q+I*ot,r[15]=b*w+T*z+y*Z+I*vt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,
this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],f=t[10],d=t[14],g=t[3],_=t[7],m=t[11],p=t[15];return g*(+r*c*u-s*l*u-r*a*f+n*l*f+s*a*d-n*c*d)+_*(+e*c*d-e*l*f+r*o*f-s*o*d+s*l*h-r*c*h)+m*(+e*l*u-e*a*d-r*o*u+n*o*d+r*a*h-n*l*h)+p*(-s*a*h-e*c*u+e*a*f+s*o*u-n*o*f+n*c*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],
t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],f=t[10],d=t[11],g=t[12],_=t[13],m=t[14],p=t[15],b=u*m*
l-_*f*l+_*c*d-a*m*d-u*c*p+a*f*p,T=g*f*l-h*m*l-g*c*d+o*m*d+h*c*p-o*f*p,y=h*_*l-g*u*l+g*a*d-o*_*d-h*a*p+o*u*p,I=g*u*c-h*_*c-g*a*f+o*_*f+h*a*m-o*u*m,A=e*b+n*T+s*y+r*I;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/A;return t[0]=b*D,t[1]=(_*f*r-u*m*r-_*s*d+n*m*d+u*s*p-n*f*p)*D,t[2]=(a*m*r-_*c*r+_*s*l-n*m*l-a*s*p+n*c*p)*D,t[3]=(u*c*r-a*f*r-u*s*l+n*f*l+a*s*d-n*c*d)*D,t[4]=T*D,t[5]=(h*
m*r-g*f*r+g*s*d-e*m*d-h*s*p+e*f*p)*D,t[6]=(g*c*r-o*m*r-g*s*l+e*m*l+o*s*p-e*c*p)*D,t[7]=(o*f*r-h*c*r+h*s*l-e*f*l-o*s*d+e*c*d)*D,t[8]=y*D,t[9]=(g*u*r-h*_*r-g*n*d+e*_*d+h*n*p-e*u*p)*D,t[10]=(o*_*r-g*a*r+g*n*l-e*_*l-o*n*p+e*a*p)*D,t[11]=(h*a*r-o*u*r-h*n*l+e*u*l+o*n*d-e*a*d)*D,t[12]=I*D,t[13]=(h*_*s-g*u*s+g*n*f-e*_*f-h*n*m+e*u*m)*D,t[14]=(g*a*s-o*_*s-g*n*c+e*_*c+o*n*m-e*a*m)*D,t[15]=(o*u*s-h*a*s+h*n*c-
e*u*c-o*n*f+e*a*f)*D,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.
set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){
let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,
f=r*l,d=r*h,g=r*u,_=o*h,m=o*u,p=a*u,b=c*l,T=c*h,y=c*u,I=n.x,A=n.y,D=n.z;return s[0]=(1-(_+p))*I,s[1]=(d+y)*I,s[2]=(g-T)*I,s[3]=0,s[4]=(d-y)*A,s[5]=(1-(f+p))*A,s[6]=(m+b)*A,s[7]=0,s[8]=(g+T)*D,s[9]=(m-b)*D,s[10]=(1-(f+_))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Xr.set(s[0],s[1],s[2]).length(),o=Xr.set(s[4],s[5],s[6]).length(),a=Xr.set(s[8],s[9],s[10]).
length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Ai.copy(this);let l=1/r,h=1/o,u=1/a;return Ai.elements[0]*=l,Ai.elements[1]*=l,Ai.elements[2]*=l,Ai.elements[4]*=h,Ai.elements[5]*=h,Ai.elements[6]*=h,Ai.elements[8]*=u,Ai.elements[9]*=u,Ai.elements[10]*=u,e.setFromRotationMatrix(Ai),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ri,c=!1){let l=this.elements,h=2*r/(e-t),u=2*
r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),g,_;if(c)g=r/(o-r),_=o*r/(o-r);else if(a===Ri)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ea)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=f,l[12]=0,l[1]=0,l[5]=u,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ri,c=!1){
let l=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),g,_;if(c)g=1/(o-r),_=o/(o-r);else if(a===Ri)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===ea)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=f,l[1]=0,l[5]=u,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=g,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){
let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=
n[15],t}},Xr=new W,Ai=new ge,Nx=new W(0,0,0),Ox=new W(1,1,1),Es=new W,xl=new W,ni=new W,Tm=new ge,Am=new di,pi=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this.
_onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this.
_order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this.
_z=0);break;case"ZXY":this._x=Math.asin(ve(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ve(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ve(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(
-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){
return Tm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Tm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Am.setFromEuler(this),this.setFromQuaternion(Am,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),
this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};pi.DEFAULT_ORDER="XYZ";var ro=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){
this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Bx=0,Cm=new W,qr=new di,es=new ge,yl=new W,$o=new W,kx=new W,zx=new di,Rm=new W(1,0,0),Pm=new W(0,1,0),Im=new W(0,0,1),Lm={type:"added"},Vx={type:"removed"},Yr={type:"childadded",child:null},Au={type:"childremoved",child:null},Sn=class i extends as{constructor(){
super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Bx++}),this.uuid=Aa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new W,e=new pi,n=new di,s=new W(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,
value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new oe}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=
!1,this.layers=new ro,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(
this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return qr.setFromAxisAngle(t,e),
this.quaternion.multiply(qr),this}rotateOnWorldAxis(t,e){return qr.setFromAxisAngle(t,e),this.quaternion.premultiply(qr),this}rotateX(t){return this.rotateOnAxis(Rm,t)}rotateY(t){return this.rotateOnAxis(Pm,t)}rotateZ(t){return this.rotateOnAxis(Im,t)}translateOnAxis(t,e){return Cm.copy(t).applyQuaternion(this.quaternion),this.position.add(Cm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(
Rm,t)}translateY(t){return this.translateOnAxis(Pm,t)}translateZ(t){return this.translateOnAxis(Im,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?yl.copy(t):yl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),$o.setFromMatrixPosition(
this.matrixWorld),this.isCamera||this.isLight?es.lookAt($o,yl,this.up):es.lookAt(yl,$o,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(s.matrixWorld),qr.setFromRotationMatrix(es),this.quaternion.premultiply(qr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: o\
bject can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Lm),Yr.child=t,this.dispatchEvent(Yr),Yr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.
children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Vx),Au.child=t,this.dispatchEvent(Au),Au.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),
es.multiply(t.parent.matrixWorld)),t.applyMatrix4(es),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Lm),Yr.child=t,this.dispatchEvent(Yr),Yr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.
children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,
!1),this.matrixWorld.decompose($o,t,kx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($o,zx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;
t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&
(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===
!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,
type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),
s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,
s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=
this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.
toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():
this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(
c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));
s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),
h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){
return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=
t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};Sn.
DEFAULT_UP=new W(0,1,0);Sn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new W,ns=new W,Cu=new W,is=new W,$r=new W,Zr=new W,Dm=new W,Ru=new W,Pu=new W,Iu=new W,Lu=new je,Du=new je,Uu=new je,ss=class i{constructor(t=new W,e=new W,n=new W){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ci.subVectors(t,e),s.cross(Ci);let r=s.lengthSq();return r>0?
s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ci.subVectors(s,e),ns.subVectors(n,e),Cu.subVectors(t,e);let o=Ci.dot(Ci),a=Ci.dot(ns),c=Ci.dot(Cu),l=ns.dot(ns),h=ns.dot(Cu),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(l*c-a*h)*f,g=(o*h-a*c)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,is)===null?!1:is.x>=0&&is.y>=
0&&is.x+is.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,is)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,is.x),c.addScaledVector(o,is.y),c.addScaledVector(a,is.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return Lu.setScalar(0),Du.setScalar(0),Uu.setScalar(0),Lu.fromBufferAttribute(t,e),Du.fromBufferAttribute(
t,n),Uu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Lu,r.x),o.addScaledVector(Du,r.y),o.addScaledVector(Uu,r.z),o}static isFrontFacing(t,e,n,s){return Ci.subVectors(n,e),ns.subVectors(t,e),Ci.cross(ns).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){
return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ci.subVectors(this.c,this.b),ns.subVectors(this.a,this.b),Ci.cross(ns).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(
1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.
c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;$r.subVectors(s,n),Zr.subVectors(r,n),Ru.subVectors(t,n);let c=$r.dot(Ru),l=Zr.dot(Ru);if(c<=0&&l<=0)return e.copy(n);Pu.subVectors(t,s);let h=$r.dot(Pu),u=Zr.dot(Pu);if(h>=0&&u<=h)return e.copy(s);let f=c*u-h*l;if(f<=0&&c>=0&&h<=0)return o=c/(c-h),e.copy(n).addScaledVector($r,o);Iu.
subVectors(t,r);let d=$r.dot(Iu),g=Zr.dot(Iu);if(g>=0&&d<=g)return e.copy(r);let _=d*l-c*g;if(_<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(n).addScaledVector(Zr,a);let m=h*g-d*u;if(m<=0&&u-h>=0&&d-g>=0)return Dm.subVectors(r,s),a=(u-h)/(u-h+(d-g)),e.copy(s).addScaledVector(Dm,a);let p=1/(m+_+f);return o=_*p,a=f*p,e.copy(n).addScaledVector($r,o).addScaledVector(Zr,a)}equals(t){return t.a.equals(this.a)&&
t.b.equals(this.b)&&t.c.equals(this.c)}},Og={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,
darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,
dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,
lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,
maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,
orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,
skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ts={h:0,s:0,l:0},Ml={h:0,s:0,l:0};function Fu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:
e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ae=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=si){return t=Math.floor(t),
this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=n,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ye.workingColorSpace){if(t=Ix(t,1),e=ve(e,0,1),n=ve(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Fu(o,r,t+1/3),this.g=Fu(o,r,t),this.b=Fu(o,
r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=si){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(
r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.
exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn(
"THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=si){let n=Og[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=rs(t.r),this.g=rs(t.g),
this.b=rs(t.b),this}copyLinearToSRGB(t){return this.r=to(t.r),this.g=to(t.g),this.b=to(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=si){return ye.workingToColorSpace(Cn.copy(this),t),Math.round(ve(Cn.r*255,0,255))*65536+Math.round(ve(Cn.g*255,0,255))*256+Math.round(ve(Cn.b*255,0,255))}getHexString(t=si){
return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(Cn.copy(this),e);let n=Cn.r,s=Cn.g,r=Cn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-n)/u+2;break;case r:c=(n-s)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=ye.
workingColorSpace){return ye.workingToColorSpace(Cn.copy(this),e),t.r=Cn.r,t.g=Cn.g,t.b=Cn.b,t}getStyle(t=si){ye.workingToColorSpace(Cn.copy(this),t);let e=Cn.r,n=Cn.g,s=Cn.b;return t!==si?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ts),this.setHSL(Ts.h+t,Ts.s+e,Ts.l+n)}add(t){
return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){
return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ts),t.getHSL(Ml);let n=vu(Ts.h,Ml.h,e),s=vu(Ts.s,Ml.s,e),r=vu(Ts.l,Ml.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.
r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(
e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Cn=new ae;ae.NAMES=Og;var Hx=0,Wi=class extends as{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Hx++}),this.uuid=Aa(),this.name="",this.type="Material",this.blending=tr,this.side=os,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=
zl,this.blendDst=Vl,this.blendEquation=Rs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ae(0,0,0),this.blendAlpha=0,this.depthFunc=er,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=js,this.stencilZFail=js,this.stencilZPass=js,this.stencilWrite=!1,this.clippingPlanes=
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
this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==tr&&(n.blending=this.blending),this.side!==os&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=
!0),this.blendSrc!==zl&&(n.blendSrc=this.blendSrc),this.blendDst!==Vl&&(n.blendDst=this.blendDst),this.blendEquation!==Rs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.
isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==er&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Xu&&
(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==js&&(n.stencilFail=this.stencilFail),this.stencilZFail!==js&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==js&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==
void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&
(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>
1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.
userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,
this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=
t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.
clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,
this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},ir=class extends Wi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ae(16777215),this.map=null,this.lightMap=null,
this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pi,this.combine=vo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.
map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var rn=new W,bl=new me,Gx=0,Xn=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Gx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=qu,this.updateRanges=[],this.gpuType=Di,this.version=0}onUploadCallback(){}set needsUpdate(t){
t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.
itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)bl.fromBufferAttribute(this,e),bl.applyMatrix3(t),this.setXY(e,bl.x,bl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)rn.fromBufferAttribute(this,e),rn.applyMatrix3(t),this.setXYZ(e,rn.x,
rn.y,rn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)rn.fromBufferAttribute(this,e),rn.applyMatrix4(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)rn.fromBufferAttribute(this,e),rn.applyNormalMatrix(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)rn.fromBufferAttribute(this,e),
rn.transformDirection(t),this.setXYZ(e,rn.x,rn.y,rn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Xo(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Wn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Xo(e,this.array)),
e}setX(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Xo(e,this.array)),e}setY(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Xo(e,this.array)),e}setZ(t,e){return this.normalized&&
(e=Wn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Xo(e,this.array)),e}setW(t,e){return this.normalized&&(e=Wn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=
this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array),s=Wn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Wn(e,this.array),n=Wn(n,this.array),s=Wn(s,this.array),r=Wn(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=
t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==qu&&(t.usage=this.usage),t}};var sa=class extends Xn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ra=class extends Xn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var _e=class extends Xn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Wx=0,fi=new ge,Nu=new Sn,Jr=new W,ii=new Gi,Zo=new Gi,xn=new W,en=class i extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Wx++}),this.uuid=Aa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=
!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(df(t)?ra:sa)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){
return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new oe().
getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return fi.makeRotationFromQuaternion(t),this.applyMatrix4(fi),this}rotateX(t){return fi.makeRotationX(t),this.applyMatrix4(
fi),this}rotateY(t){return fi.makeRotationY(t),this.applyMatrix4(fi),this}rotateZ(t){return fi.makeRotationZ(t),this.applyMatrix4(fi),this}translate(t,e,n){return fi.makeTranslation(t,e,n),this.applyMatrix4(fi),this}scale(t,e,n){return fi.makeScale(t,e,n),this.applyMatrix4(fi),this}lookAt(t){return Nu.lookAt(t),Nu.updateMatrix(),this.applyMatrix4(Nu.matrix),this}center(){return this.computeBoundingBox(),
this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new _e(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.Buff\
erGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),
this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ii.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,ii.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,ii.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.
expandByPoint(ii.min),this.boundingBox.expandByPoint(ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.
boundingSphere=new ls);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let n=this.boundingSphere.center;if(ii.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Zo.setFromBufferAttribute(
a),this.morphTargetsRelative?(xn.addVectors(ii.min,Zo.min),ii.expandByPoint(xn),xn.addVectors(ii.max,Zo.max),ii.expandByPoint(xn)):(ii.expandByPoint(Zo.min),ii.expandByPoint(Zo.max))}ii.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)xn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(xn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<
h;l++)xn.fromBufferAttribute(a,l),c&&(Jr.fromBufferAttribute(t,l),xn.add(Jr)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||
e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Xn(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],c=[];for(let N=0;N<n.count;N++)a[N]=
new W,c[N]=new W;let l=new W,h=new W,u=new W,f=new me,d=new me,g=new me,_=new W,m=new W;function p(N,w,S){l.fromBufferAttribute(n,N),h.fromBufferAttribute(n,w),u.fromBufferAttribute(n,S),f.fromBufferAttribute(r,N),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),h.sub(l),u.sub(l),d.sub(f),g.sub(f);let C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(_.copy(h).multiplyScalar(g.y).addScaledVector(u,-d.y).multiplyScalar(
C),m.copy(u).multiplyScalar(d.x).addScaledVector(h,-g.x).multiplyScalar(C),a[N].add(_),a[w].add(_),a[S].add(_),c[N].add(m),c[w].add(m),c[S].add(m))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let N=0,w=b.length;N<w;++N){let S=b[N],C=S.start,O=S.count;for(let z=C,G=C+O;z<G;z+=3)p(t.getX(z+0),t.getX(z+1),t.getX(z+2))}let T=new W,y=new W,I=new W,A=new W;function D(N){I.fromBufferAttribute(
s,N),A.copy(I);let w=a[N];T.copy(w),T.sub(I.multiplyScalar(I.dot(w))).normalize(),y.crossVectors(A,w);let C=y.dot(c[N])<0?-1:1;o.setXYZW(N,T.x,T.y,T.z,C)}for(let N=0,w=b.length;N<w;++N){let S=b[N],C=S.start,O=S.count;for(let z=C,G=C+O;z<G;z+=3)D(t.getX(z+0)),D(t.getX(z+1)),D(t.getX(z+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute(
"normal");if(n===void 0)n=new Xn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,c=new W,l=new W,h=new W,u=new W;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),_=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(
s,r),h.cross(u),a.fromBufferAttribute(n,g),c.fromBufferAttribute(n,_),l.fromBufferAttribute(n,m),a.add(h),c.add(h),l.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(_,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(
f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)xn.fromBufferAttribute(t,e),xn.normalize(),t.setXYZ(e,xn.x,xn.y,xn.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,f=new l.constructor(c.length*h),d=0,g=0;for(let _=0,m=c.length;_<m;_++){a.isInterleavedBufferAttribute?
d=c[_]*a.data.stride+a.offset:d=c[_]*h;for(let p=0;p<h;p++)f[g++]=l[d++]}return new Xn(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<
u;h++){let f=l[h],d=t(f,n);c.push(d)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(
this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.
morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,f=l.length;u<f;u++){let d=l[u];h.push(d.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.
constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let f=0,d=u.length;f<d;f++)h.push(
u[f].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,
this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Um=new ge,Js=new so,Sl=new ls,Fm=new W,wl=new W,El=new W,Tl=new W,Ou=new W,Al=new W,Nm=new W,Cl=new W,wn=class extends Sn{constructor(t=new en,e=new ir){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){
return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.
length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;
if(r&&a){Al.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Ou.fromBufferAttribute(u,t),o?Al.addScaledVector(Ou,h):Al.addScaledVector(Ou.sub(e),h))}e.add(Al)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Sl.copy(n.boundingSphere),Sl.applyMatrix4(r),Js.copy(t.ray).recast(t.near),!(Sl.
containsPoint(Js.origin)===!1&&(Js.intersectSphere(Sl,Fm)===null||Js.origin.distanceToSquared(Fm)>(t.far-t.near)**2))&&(Um.copy(r).invert(),Js.copy(t.ray).applyMatrix4(Um),!(n.boundingBox!==null&&Js.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Js)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.
uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],p=o[m.materialIndex],b=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let y=b,I=T;y<I;y+=3){let A=a.getX(y),D=a.getX(y+1),N=a.getX(y+2);s=Rl(this,p,t,n,l,h,u,A,D,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,
e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let m=g,p=_;m<p;m+=3){let b=a.getX(m),T=a.getX(m+1),y=a.getX(m+2);s=Rl(this,o,t,n,l,h,u,b,T,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],p=o[m.materialIndex],b=Math.max(m.start,d.start),T=Math.min(c.count,Math.min(m.start+m.count,d.start+
d.count));for(let y=b,I=T;y<I;y+=3){let A=y,D=y+1,N=y+2;s=Rl(this,p,t,n,l,h,u,A,D,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(c.count,d.start+d.count);for(let m=g,p=_;m<p;m+=3){let b=m,T=m+1,y=m+2;s=Rl(this,o,t,n,l,h,u,b,T,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Xx(i,t,e,n,s,r,o,a){let c;if(t.side===
zn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===os,a),c===null)return null;Cl.copy(a),Cl.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Cl);return l<e.near||l>e.far?null:{distance:l,point:Cl.clone(),object:i}}function Rl(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,wl),i.getVertexPosition(c,El),i.getVertexPosition(l,Tl);let h=Xx(i,t,e,n,wl,El,Tl,Nm);if(h){let u=new W;
ss.getBarycoord(Nm,wl,El,Tl,u),s&&(h.uv=ss.getInterpolatedAttribute(s,a,c,l,u,new me)),r&&(h.uv1=ss.getInterpolatedAttribute(r,a,c,l,u,new me)),o&&(h.normal=ss.getInterpolatedAttribute(o,a,c,l,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:c,c:l,normal:new W,materialIndex:0};ss.getNormal(wl,El,Tl,f.normal),h.face=f,h.barycoord=u}return h}var cs=class i extends en{constructor(t=1,e=1,n=1,s=1,r=1,o=1){
super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,
-n,s,r,5),this.setIndex(c),this.setAttribute("position",new _e(l,3)),this.setAttribute("normal",new _e(h,3)),this.setAttribute("uv",new _e(u,2));function g(_,m,p,b,T,y,I,A,D,N,w){let S=y/D,C=I/N,O=y/2,z=I/2,G=A/2,X=D+1,q=N+1,Z=0,j=0,rt=new W;for(let ot=0;ot<q;ot++){let vt=ot*C-z;for(let xt=0;xt<X;xt++){let pt=xt*S-O;rt[_]=pt*b,rt[m]=vt*T,rt[p]=G,l.push(rt.x,rt.y,rt.z),rt[_]=0,rt[m]=0,rt[p]=A>0?1:-1,
h.push(rt.x,rt.y,rt.z),u.push(xt/D),u.push(1-ot/N),Z+=1}}for(let ot=0;ot<N;ot++)for(let vt=0;vt<D;vt++){let xt=f+vt+X*ot,pt=f+vt+X*(ot+1),ee=f+(vt+1)+X*(ot+1),Zt=f+(vt+1)+X*ot;c.push(xt,pt,Zt),c.push(pt,ee,Zt),j+=6}a.addGroup(d,j,w),d+=j,f+=Z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.
heightSegments,t.depthSegments)}};function hr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.
isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Pn(i){let t={};for(let e=0;e<i.length;e++){let n=hr(i[e]);for(let s in n)t[s]=n[s]}return t}function qx(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function pf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var Bg={clone:hr,merge:Pn},
Yx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,$x=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ii=class extends Wi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Yx,this.fragmentShader=$x,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues=
{color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=hr(t.uniforms),this.uniformsGroups=qx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.
getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=
this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},oa=class extends Sn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,
this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){
super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},As=new W,Om=new me,Bm=new me,Rn=class extends oa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,
this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){
let e=.5*this.getFilmHeight()/t;this.fov=Xl*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(kl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Xl*2*Math.atan(Math.tan(kl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){As.set(-1,
-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(As.x,As.y).multiplyScalar(-t/As.z),As.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(As.x,As.y).multiplyScalar(-t/As.z)}getViewSize(t,e){return this.getViewBounds(t,Om,Bm),e.subVectors(Bm,Om)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),
this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(kl*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&
this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,
e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Kr=-90,jr=1,Zl=class extends Sn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=
0;let s=new Rn(Kr,jr,t,e);s.layers=this.layers,this.add(s);let r=new Rn(Kr,jr,t,e);r.layers=this.layers,this.add(r);let o=new Rn(Kr,jr,t,e);o.layers=this.layers,this.add(o);let a=new Rn(Kr,jr,t,e);a.layers=this.layers,this.add(a);let c=new Rn(Kr,jr,t,e);c.layers=this.layers,this.add(c);let l=new Rn(Kr,jr,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.
children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Ri)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===ea)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),
o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.
coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let _=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,c),
t.setRenderTarget(n,4,s),t.render(e,l),n.texture.generateMipmaps=_,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},aa=class extends Yn{constructor(t=[],e=lr,n,s,r,o,a,c,l,h){super(t,e,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Jl=class extends Hi{constructor(t=1,e={}){
super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new aa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={
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
			`},s=new cs(5,5,5),r=new Ii({name:"CubemapFromEquirect",uniforms:hr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:zn,blending:hs});r.uniforms.tEquirect.value=e;let o=new wn(s,r),a=e.minFilter;return e.minFilter===Ls&&(e.minFilter=Pi),new Zl(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();
for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Qs=class extends Sn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Zx={type:"move"},oo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.
inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qs,
this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){
let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,
c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,n),p=this._getHandJoint(l,_);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=l.joints["index-finger-tip"],u=l.joints["th\
umb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;l.inputState.pinching&&f>d+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&f<=d-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.
fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.rotation,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&
(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Zx)))}return a!==null&&(a.visible=s!==null),c!==
null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Qs;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}};var la=class extends Sn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new pi,this.environmentIntensity=1,this.environmentRotation=new pi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",
{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,
this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=
this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var Kl=class extends Yn{constructor(t=null,e=1,n=1,s,r,o,a,c,l=qn,h=qn,u,f){super(null,o,a,c,l,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ca=class extends Xn{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Qr=new ge,km=new ge,Pl=[],zm=new Gi,Jx=new ge,Jo=new wn,Ko=new ls,ha=class extends wn{constructor(t,e,n){
super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ca(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Jx)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Gi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.
makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Qr),zm.copy(t.boundingBox).applyMatrix4(Qr),this.boundingBox.union(zm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ls),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Qr),Ko.copy(t.boundingSphere).applyMatrix4(
Qr),this.boundingSphere.union(Ko)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),t.morphTexture!==null&&(this.morphTexture=t.morphTexture.clone()),t.instanceColor!==null&&(this.instanceColor=t.instanceColor.clone()),this.count=t.count,t.boundingBox!==null&&(this.boundingBox=t.boundingBox.clone()),t.boundingSphere!==null&&(this.boundingSphere=t.boundingSphere.clone()),this}getColorAt(t,e){
e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Jo.geometry=this.geometry,Jo.material=this.material,Jo.material!==void 0&&(this.boundingSphere===null&&
this.computeBoundingSphere(),Ko.copy(this.boundingSphere),Ko.applyMatrix4(n),t.ray.intersectsSphere(Ko)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Qr),km.multiplyMatrices(n,Qr),Jo.matrixWorld=km,Jo.raycast(t,Pl);for(let o=0,a=Pl.length;o<a;o++){let c=Pl[o];c.instanceId=r,c.object=this,e.push(c)}Pl.length=0}}setColorAt(t,e){this.instanceColor===null&&(this.instanceColor=new ca(new Float32Array(this.
instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3)}setMatrixAt(t,e){e.toArray(this.instanceMatrix.array,t*16)}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Kl(new Float32Array(s*this.count),s,this.count,Tc,Di));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?
1:1-o,c=s*t;r[c]=a,r.set(n,c+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Bu=new W,Kx=new W,jx=new oe,Vi=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(
t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Bu.subVectors(n,e).cross(Kx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.
multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(Bu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(
t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(
-this.constant)}applyMatrix4(t,e){let n=e||jx.getNormalMatrix(t),s=this.coplanarPoint(Bu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},Ks=new ls,Qx=new me(.5,.5),Il=new W,
ao=class{constructor(t=new Vi,e=new Vi,n=new Vi,s=new Vi,r=new Vi,o=new Vi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ri,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],
h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],_=r[9],m=r[10],p=r[11],b=r[12],T=r[13],y=r[14],I=r[15];if(s[0].setComponents(l-o,d-h,p-g,I-b).normalize(),s[1].setComponents(l+o,d+h,p+g,I+b).normalize(),s[2].setComponents(l+a,d+u,p+_,I+T).normalize(),s[3].setComponents(l-a,d-u,p-_,I-T).normalize(),n)s[4].setComponents(c,f,m,y).normalize(),s[5].setComponents(l-c,d-f,p-m,I-y).normalize();else if(s[4].setComponents(
l-c,d-f,p-m,I-y).normalize(),e===Ri)s[5].setComponents(l+c,d+f,p+m,I+y).normalize();else if(e===ea)s[5].setComponents(c,f,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ks.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{
let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ks.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ks)}intersectsSprite(t){Ks.center.set(0,0,0);let e=Qx.distanceTo(t.center);return Ks.radius=.7071067811865476+e,Ks.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ks)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)
if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Il.x=s.normal.x>0?t.max.x:t.min.x,Il.y=s.normal.y>0?t.max.y:t.min.y,Il.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Il)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().
copy(this)}};var lo=class extends Wi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ae(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},
jl=new W,Ql=new W,Vm=new ge,jo=new so,Ll=new ls,ku=new W,Hm=new W,co=class extends Sn{constructor(t=new en,e=new lo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=
t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)jl.fromBufferAttribute(e,s-1),Ql.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=jl.distanceTo(Ql);t.setAttribute("lineDistance",new _e(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){
let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ll.copy(n.boundingSphere),Ll.applyMatrix4(s),Ll.radius+=r,t.ray.intersectsSphere(Ll)===!1)return;Vm.copy(s).invert(),jo.copy(t.ray).applyMatrix4(Vm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;
if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let _=d,m=g-1;_<m;_+=l){let p=h.getX(_),b=h.getX(_+1),T=Dl(this,t,jo,c,p,b,_);T&&e.push(T)}if(this.isLineLoop){let _=h.getX(g-1),m=h.getX(d),p=Dl(this,t,jo,c,_,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let _=d,m=g-1;_<m;_+=l){let p=Dl(this,t,jo,c,_,_+1,_);p&&e.push(p)}if(this.
isLineLoop){let _=Dl(this,t,jo,c,g-1,d,g-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Dl(i,t,e,n,s,r,o){let a=i.
geometry.attributes.position;if(jl.fromBufferAttribute(a,s),Ql.fromBufferAttribute(a,r),e.distanceSqToSegment(jl,Ql,ku,Hm)>n)return;ku.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(ku);if(!(l<t.near||l>t.far))return{distance:l,point:Hm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Gm=new W,Wm=new W,ho=class extends co{constructor(t,e){
super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Gm.fromBufferAttribute(e,s),Wm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Gm.distanceTo(Wm);t.setAttribute("lineDistance",new _e(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Co\
mputation only possible with non-indexed BufferGeometry.");return this}};var ua=class extends Yn{constructor(t,e,n=Ds,s,r,o,a=qn,c=qn,l,h=eo,u=1){if(h!==eo&&h!==Mo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new io(Object.assign({},
t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},fa=class extends Yn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},da=class i extends en{constructor(t=1,e=1,n=4,s=8,r=1){super(),this.
type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:n,radialSegments:s,heightSegments:r},e=Math.max(0,e),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],c=[],l=[],h=e/2,u=Math.PI/2*t,f=e,d=2*u+f,g=n*2+r,_=s+1,m=new W,p=new W;for(let b=0;b<=g;b++){let T=0,y=0,I=0,A=0;if(b<=n){let w=b/n,S=w*Math.PI/2;y=-h-t*Math.cos(S),I=t*Math.sin(
S),A=-t*Math.cos(S),T=w*u}else if(b<=n+r){let w=(b-n)/r;y=-h+w*e,I=t,A=0,T=u+w*f}else{let w=(b-n-r)/n,S=w*Math.PI/2;y=h+t*Math.sin(S),I=t*Math.cos(S),A=t*Math.sin(S),T=u+f+w*u}let D=Math.max(0,Math.min(1,T/d)),N=0;b===0?N=.5/s:b===g&&(N=-.5/s);for(let w=0;w<=s;w++){let S=w/s,C=S*Math.PI*2,O=Math.sin(C),z=Math.cos(C);p.x=-I*z,p.y=y,p.z=I*O,a.push(p.x,p.y,p.z),m.set(-I*z,A,I*O),m.normalize(),c.push(
m.x,m.y,m.z),l.push(S+N,D)}if(b>0){let w=(b-1)*_;for(let S=0;S<s;S++){let C=w+S,O=w+S+1,z=b*_+S,G=b*_+S+1;o.push(C,O,z),o.push(O,G,z)}}}this.setIndex(o),this.setAttribute("position",new _e(a,3)),this.setAttribute("normal",new _e(c,3)),this.setAttribute("uv",new _e(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.height,
t.capSegments,t.radialSegments,t.heightSegments)}};var uo=class i extends en{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],g=0,_=[],m=n/2,p=0;b(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(h),this.setAttribute(
"position",new _e(u,3)),this.setAttribute("normal",new _e(f,3)),this.setAttribute("uv",new _e(d,2));function b(){let y=new W,I=new W,A=0,D=(e-t)/n;for(let N=0;N<=r;N++){let w=[],S=N/r,C=S*(e-t)+t;for(let O=0;O<=s;O++){let z=O/s,G=z*c+a,X=Math.sin(G),q=Math.cos(G);I.x=C*X,I.y=-S*n+m,I.z=C*q,u.push(I.x,I.y,I.z),y.set(X,D,q).normalize(),f.push(y.x,y.y,y.z),d.push(z,1-S),w.push(g++)}_.push(w)}for(let N=0;N<
s;N++)for(let w=0;w<r;w++){let S=_[w][N],C=_[w+1][N],O=_[w+1][N+1],z=_[w][N+1];(t>0||w!==0)&&(h.push(S,C,z),A+=3),(e>0||w!==r-1)&&(h.push(C,O,z),A+=3)}l.addGroup(p,A,0),p+=A}function T(y){let I=g,A=new me,D=new W,N=0,w=y===!0?t:e,S=y===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;let C=g;for(let O=0;O<=s;O++){let G=O/s*c+a,X=Math.cos(G),q=Math.sin(G);D.x=w*q,D.y=m*S,
D.z=w*X,u.push(D.x,D.y,D.z),f.push(0,S,0),A.x=X*.5+.5,A.y=q*.5*S+.5,d.push(A.x,A.y),g++}for(let O=0;O<s;O++){let z=I+O,G=C+O;y===!0?h.push(G,G+1,z):h.push(G+1,G,z),N+=3}l.addGroup(p,N,y===!0?1:2),p+=N}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,
t.thetaLength)}},pa=class i extends uo{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Ul=new W,Fl=new W,zu=new W,Nl=new ss,fo=class extends en{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(kl*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],u=new Array(3),f={},d=[];for(let g=0;g<c;g+=3){o?(l[0]=o.getX(g),l[1]=o.getX(g+1),l[2]=o.getX(
g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:_,b:m,c:p}=Nl;if(_.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),p.fromBufferAttribute(a,l[2]),Nl.getNormal(zu),u[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||
u[2]===u[0]))for(let b=0;b<3;b++){let T=(b+1)%3,y=u[b],I=u[T],A=Nl[h[b]],D=Nl[h[T]],N=`${y}_${I}`,w=`${I}_${y}`;w in f&&f[w]?(zu.dot(f[w].normal)<=r&&(d.push(A.x,A.y,A.z),d.push(D.x,D.y,D.z)),f[w]=null):N in f||(f[N]={index0:l[b],index1:l[T],normal:zu.clone()})}}for(let g in f)if(f[g]){let{index0:_,index1:m}=f[g];Ul.fromBufferAttribute(a,_),Fl.fromBufferAttribute(a,m),d.push(Ul.x,Ul.y,Ul.z),d.push(
Fl.x,Fl.y,Fl.z)}this.setAttribute("position",new _e(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var sr=class i extends en{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,u=t/a,f=e/c,d=[],g=[],_=[],m=[];for(let p=0;p<h;p++){let b=p*f-o;for(let T=0;T<l;T++){let y=T*u-r;g.push(y,-b,0),_.push(0,0,1),m.push(T/a),m.push(1-p/c)}}for(let p=0;p<c;p++)for(let b=0;b<
a;b++){let T=b+l*p,y=b+l*(p+1),I=b+1+l*(p+1),A=b+1+l*p;d.push(T,y,A),d.push(y,I,A)}this.setIndex(d),this.setAttribute("position",new _e(g,3)),this.setAttribute("normal",new _e(_,3)),this.setAttribute("uv",new _e(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var po=class i extends en{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new W,f=new W,d=[],g=[],_=[],m=[];for(let p=0;p<=n;p++){let b=[],T=p/n,y=0;p===
0&&o===0?y=.5/e:p===n&&c===Math.PI&&(y=-.5/e);for(let I=0;I<=e;I++){let A=I/e;u.x=-t*Math.cos(s+A*r)*Math.sin(o+T*a),u.y=t*Math.cos(o+T*a),u.z=t*Math.sin(s+A*r)*Math.sin(o+T*a),g.push(u.x,u.y,u.z),f.copy(u).normalize(),_.push(f.x,f.y,f.z),m.push(A+y,1-T),b.push(l++)}h.push(b)}for(let p=0;p<n;p++)for(let b=0;b<e;b++){let T=h[p][b+1],y=h[p][b],I=h[p+1][b],A=h[p+1][b+1];(p!==0||o>0)&&d.push(T,y,A),(p!==
n-1||c<Math.PI)&&d.push(y,I,A)}this.setIndex(d),this.setAttribute("position",new _e(g,3)),this.setAttribute("normal",new _e(_,3)),this.setAttribute("uv",new _e(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ma=class i extends en{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],c=[],l=[],h=new W,u=new W,f=new W;for(let d=0;d<=n;d++)for(let g=0;g<=s;g++){let _=g/s*r,m=d/n*Math.PI*2;u.x=(t+e*Math.cos(m))*Math.cos(_),u.y=(t+e*Math.cos(m))*Math.sin(_),u.
z=e*Math.sin(m),a.push(u.x,u.y,u.z),h.x=t*Math.cos(_),h.y=t*Math.sin(_),f.subVectors(u,h).normalize(),c.push(f.x,f.y,f.z),l.push(g/s),l.push(d/n)}for(let d=1;d<=n;d++)for(let g=1;g<=s;g++){let _=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,b=(s+1)*d+g;o.push(_,m,b),o.push(m,p,b)}this.setIndex(o),this.setAttribute("position",new _e(a,3)),this.setAttribute("normal",new _e(c,3)),this.setAttribute("u\
v",new _e(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}};var mo=class extends Wi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ae(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=
1,this.normalMap=null,this.normalMapType=sh,this.normalScale=new me(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=
!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,
this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.
copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var rr=class extends Wi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ae(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=sh,this.normalScale=new me(
1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pi,this.combine=vo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.
copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.
copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=
t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},tc=class extends Wi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Eg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=
!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ec=class extends Wi{constructor(t){super(),this.isMeshDistanceMaterial=
!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ol(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ty(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var or=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=
n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(
0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstra\
ct method")}intervalChanged_(){}},nc=class extends or{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hu,endingEnd:Hu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Gu:r=t,a=2*e-n;break;case Wu:r=s.length-
2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Gu:o=t,c=2*n-e;break;case Wu:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,
u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),_=g*g,m=_*g,p=-f*m+2*f*_-f*g,b=(1+f)*m+(-1.5-2*f)*_+(-.5+f)*g+1,T=(-1-d)*m+(1.5+d)*_+.5*g,y=d*m-d*_;for(let I=0;I!==a;++I)r[I]=p*o[h+I]+b*o[l+I]+T*o[c+I]+y*o[u+I];return r}},ic=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-
e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[l+f]*u+o[c+f]*h;return r}},sc=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ri=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.
times=Ol(e,this.TimeBufferType),this.values=Ol(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ol(t.times,Array),values:Ol(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){
return new sc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new ic(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new nc(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case Qo:e=this.InterpolantFactoryMethodDiscrete;break;case Wl:e=this.InterpolantFactoryMethodLinear;break;case Bl:e=
this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.
createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Qo;case this.InterpolantFactoryMethodLinear:return Wl;case this.InterpolantFactoryMethodSmooth:return Bl}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}
return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);
let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&ty(s))
for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Bl,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let u=a*n,f=u-n,d=u+n;for(let g=0;g!==
n;++g){let _=e[u+g];if(_!==e[f+g]||_!==e[d+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(
this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};ri.prototype.ValueTypeName="";ri.prototype.TimeBufferType=Float32Array;ri.prototype.ValueBufferType=Float32Array;ri.prototype.DefaultInterpolation=Wl;var Ps=class extends ri{constructor(t,e,n){super(t,e,n)}};Ps.prototype.ValueTypeName="bool";Ps.prototype.ValueBufferType=Array;Ps.prototype.DefaultInterpolation=Qo;Ps.prototype.InterpolantFactoryMethodLinear=
void 0;Ps.prototype.InterpolantFactoryMethodSmooth=void 0;var rc=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};rc.prototype.ValueTypeName="color";var oc=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};oc.prototype.ValueTypeName="number";var ac=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-
e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)di.slerpFlat(r,0,o,l-a,o,l,c);return r}},ga=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new ac(this.times,this.values,this.getValueSize(),t)}};ga.prototype.ValueTypeName="quaternion";ga.prototype.InterpolantFactoryMethodSmooth=void 0;var Is=class extends ri{constructor(t,e,n){super(t,e,n)}};Is.prototype.ValueTypeName=
"string";Is.prototype.ValueBufferType=Array;Is.prototype.DefaultInterpolation=Qo;Is.prototype.InterpolantFactoryMethodLinear=void 0;Is.prototype.InterpolantFactoryMethodSmooth=void 0;var lc=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};lc.prototype.ValueTypeName="vector";var cc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==
void 0&&s.onError(h)},this.resolveURL=function(h){return c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=l.length;u<f;u+=2){let d=l[u],g=l[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.
abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},kg=new cc,hc=class{constructor(t){this.manager=t!==void 0?t:kg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=
t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};hc.DEFAULT_MATERIAL_NAME="__DEFAULT";var go=class extends Sn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ae(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),
this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},va=class extends go{constructor(t,e,n){super(t,n),this.isHemisphereLight=
!0,this.type="HemisphereLight",this.position.copy(Sn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ae(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}},Vu=new ge,Xm=new W,qm=new W,Yu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new me(512,512),this.mapType=Li,this.map=null,this.mapPass=
null,this.matrix=new ge,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ao,this._frameExtents=new me(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera,n=this.matrix;Xm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Xm),qm.setFromMatrixPosition(t.target.matrixWorld),
e.lookAt(qm),e.updateMatrixWorld(),Vu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Vu,e.coordinateSystem,e.reversedDepth),e.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Vu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.
map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return this.intensity!==
1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}};var ar=class extends oa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,
this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.
view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.
zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.
top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},$u=class extends Yu{constructor(){super(new ar(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_a=class extends go{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Sn.DEFAULT_UP),this.updateMatrix(),
this.target=new Sn,this.shadow=new $u}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}},xa=class extends go{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var uc=class extends Rn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var mf="\\[\\]\\.:\\/",ey=new RegExp("["+mf+"]","g"),gf="[^"+mf+"]",ny="[^"+mf.replace("\\.","")+"]",iy=/((?:WC+[\/:])*)/.source.replace("WC",gf),sy=/(WCOD+)?/.source.replace("WCOD",ny),ry=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gf),oy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gf),ay=new RegExp("^"+iy+sy+ry+oy+"$"),ly=["material","materials","bones","map"],Zu=class{constructor(t,e,n){let s=n||
Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)
t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.
Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ey,"")}static parseTrackName(t){let e=ay.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(
s+1);ly.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){
let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){
t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=
!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=
!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(
t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.
objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bi\
nd to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.
bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:
if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+
l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geo\
metry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.
HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=Zu;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,
HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],
[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Dw=new Float32Array(1);var Ym=new ge,ya=class{constructor(t,e,n=0,s=1/0){this.ray=new so(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new ro,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).
normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Ym.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.
ray.direction.set(0,0,-1).applyMatrix4(Ym),this}intersectObject(t,e=!0,n=[]){return Ju(t,this,n,e),n.sort($m),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)Ju(t[s],this,n,e);return n.sort($m),n}};function $m(i,t){return i.distance-t.distance}function Ju(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<
a;o++)Ju(r[o],t,e,!0)}}function vf(i,t,e,n){let s=cy(n);switch(e){case lf:return i*t;case Tc:return i*t/s.components*s.byteLength;case Ac:return i*t/s.components*s.byteLength;case hf:return i*t*2/s.components*s.byteLength;case Cc:return i*t*2/s.components*s.byteLength;case cf:return i*t*3/s.components*s.byteLength;case gi:return i*t*4/s.components*s.byteLength;case Rc:return i*t*4/s.components*s.byteLength;case Sa:case wa:
return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ea:case Ta:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ic:case Dc:return Math.max(i,16)*Math.max(t,8)/4;case Pc:case Lc:return Math.max(i,8)*Math.max(t,8)/2;case Uc:case Fc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Nc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Oc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*
16;case Bc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case kc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case zc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Vc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Hc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Gc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Wc:return Math.floor((i+7)/8)*Math.floor((t+
7)/8)*16;case Xc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case qc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Yc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case $c:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Zc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Jc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Kc:case jc:case Qc:return Math.
ceil(i/4)*Math.ceil(t/4)*16;case th:case eh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case nh:case ih:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function cy(i){switch(i){case Li:case sf:return{byteLength:1,components:1};case _o:case rf:case xo:return{byteLength:2,components:1};case wc:case Ec:return{byteLength:2,components:4};case Ds:case Sc:case Di:
return{byteLength:4,components:1};case of:case af:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function c0(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function uy(i){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,f=i.createBuffer();i.bindBuffer(
c,f),i.bufferData(c,l,h),a.onUploadCallback();let d;if(l instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=i.SHORT;else if(l instanceof Uint32Array)d=i.UNSIGNED_INT;else if(l instanceof Int32Array)d=i.INT;else if(l instanceof
Int8Array)d=i.BYTE;else if(l instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:f,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(i.bindBuffer(l,a),u.length===0)i.bufferSubData(l,0,h);else{
u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],_=u[d];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++f,u[f]=_)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let _=u[d];i.bufferSubData(l,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),
t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<
a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var fy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dy=`#ifdef USE_ALPHAHASH
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
#endif`,py=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,my=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,gy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,vy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_y=`#ifdef USE_AOMAP
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
#endif`,xy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,yy=`#ifdef USE_BATCHING
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
#endif`,My=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,by=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,wy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ey=`#ifdef USE_IRIDESCENCE
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
#endif`,Ty=`#ifdef USE_BUMPMAP
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
#endif`,Ay=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Cy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ry=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Py=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Iy=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Ly=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Dy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Uy=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Fy=`#define PI 3.141592653589793
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
} // validated`,Ny=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Oy=`vec3 transformedNormal = objectNormal;
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
#endif`,By=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ky=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,zy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Vy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Hy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Gy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Wy=`#ifdef USE_ENVMAP
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
#endif`,Xy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,qy=`#ifdef USE_ENVMAP
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
#endif`,Yy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,$y=`#ifdef USE_ENVMAP
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
#endif`,Zy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Jy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ky=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,jy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Qy=`#ifdef USE_GRADIENTMAP
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
}`,tM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,eM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,nM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,iM=`uniform bool receiveShadow;
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
#endif`,sM=`#ifdef USE_ENVMAP
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
#endif`,rM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,oM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,aM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,cM=`PhysicalMaterial material;
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
#endif`,hM=`struct PhysicalMaterial {
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
}`,uM=`
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
#endif`,fM=`#if defined( RE_IndirectDiffuse )
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
#endif`,dM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,pM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,mM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_M=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,xM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,yM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,MM=`#if defined( USE_POINTS_UV )
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
#endif`,bM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,SM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,wM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,EM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,TM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,AM=`#ifdef USE_MORPHTARGETS
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
#endif`,CM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,RM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,PM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,IM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,LM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,DM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,UM=`#ifdef USE_NORMALMAP
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
#endif`,FM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,NM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,OM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,BM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,kM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,zM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,VM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,HM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,GM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,WM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,XM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,qM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,YM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,$M=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ZM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,JM=`float getShadowMask() {
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
}`,KM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,jM=`#ifdef USE_SKINNING
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
#endif`,QM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,tb=`#ifdef USE_SKINNING
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
#endif`,eb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,nb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ib=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,sb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,rb=`#ifdef USE_TRANSMISSION
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
#endif`,ob=`#ifdef USE_TRANSMISSION
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
#endif`,ab=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,lb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,cb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,hb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ub=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,fb=`uniform sampler2D t2D;
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
}`,db=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,pb=`#ifdef ENVMAP_TYPE_CUBE
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
}`,mb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,gb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vb=`#include <common>
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
}`,_b=`#if DEPTH_PACKING == 3200
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
}`,xb=`#define DISTANCE
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
}`,yb=`#define DISTANCE
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
}`,Mb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sb=`uniform float scale;
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
}`,wb=`uniform vec3 diffuse;
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
}`,Eb=`#include <common>
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
}`,Tb=`uniform vec3 diffuse;
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
}`,Ab=`#define LAMBERT
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
}`,Cb=`#define LAMBERT
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
}`,Rb=`#define MATCAP
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
}`,Pb=`#define MATCAP
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
}`,Ib=`#define NORMAL
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
}`,Lb=`#define NORMAL
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
}`,Db=`#define PHONG
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
}`,Ub=`#define PHONG
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
}`,Fb=`#define STANDARD
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
}`,Nb=`#define STANDARD
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
}`,Ob=`#define TOON
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
}`,Bb=`#define TOON
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
}`,kb=`uniform float size;
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
}`,zb=`uniform vec3 diffuse;
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
}`,Vb=`#include <common>
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
}`,Hb=`uniform vec3 color;
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
}`,Gb=`uniform float rotation;
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
}`,Wb=`uniform vec3 diffuse;
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
}`,ce={alphahash_fragment:fy,alphahash_pars_fragment:dy,alphamap_fragment:py,alphamap_pars_fragment:my,alphatest_fragment:gy,alphatest_pars_fragment:vy,aomap_fragment:_y,aomap_pars_fragment:xy,batching_pars_vertex:yy,batching_vertex:My,begin_vertex:by,beginnormal_vertex:Sy,bsdfs:wy,iridescence_fragment:Ey,bumpmap_pars_fragment:Ty,clipping_planes_fragment:Ay,clipping_planes_pars_fragment:Cy,clipping_planes_pars_vertex:Ry,
clipping_planes_vertex:Py,color_fragment:Iy,color_pars_fragment:Ly,color_pars_vertex:Dy,color_vertex:Uy,common:Fy,cube_uv_reflection_fragment:Ny,defaultnormal_vertex:Oy,displacementmap_pars_vertex:By,displacementmap_vertex:ky,emissivemap_fragment:zy,emissivemap_pars_fragment:Vy,colorspace_fragment:Hy,colorspace_pars_fragment:Gy,envmap_fragment:Wy,envmap_common_pars_fragment:Xy,envmap_pars_fragment:qy,
envmap_pars_vertex:Yy,envmap_physical_pars_fragment:sM,envmap_vertex:$y,fog_vertex:Zy,fog_pars_vertex:Jy,fog_fragment:Ky,fog_pars_fragment:jy,gradientmap_pars_fragment:Qy,lightmap_pars_fragment:tM,lights_lambert_fragment:eM,lights_lambert_pars_fragment:nM,lights_pars_begin:iM,lights_toon_fragment:rM,lights_toon_pars_fragment:oM,lights_phong_fragment:aM,lights_phong_pars_fragment:lM,lights_physical_fragment:cM,
lights_physical_pars_fragment:hM,lights_fragment_begin:uM,lights_fragment_maps:fM,lights_fragment_end:dM,logdepthbuf_fragment:pM,logdepthbuf_pars_fragment:mM,logdepthbuf_pars_vertex:gM,logdepthbuf_vertex:vM,map_fragment:_M,map_pars_fragment:xM,map_particle_fragment:yM,map_particle_pars_fragment:MM,metalnessmap_fragment:bM,metalnessmap_pars_fragment:SM,morphinstance_vertex:wM,morphcolor_vertex:EM,morphnormal_vertex:TM,
morphtarget_pars_vertex:AM,morphtarget_vertex:CM,normal_fragment_begin:RM,normal_fragment_maps:PM,normal_pars_fragment:IM,normal_pars_vertex:LM,normal_vertex:DM,normalmap_pars_fragment:UM,clearcoat_normal_fragment_begin:FM,clearcoat_normal_fragment_maps:NM,clearcoat_pars_fragment:OM,iridescence_pars_fragment:BM,opaque_fragment:kM,packing:zM,premultiplied_alpha_fragment:VM,project_vertex:HM,dithering_fragment:GM,
dithering_pars_fragment:WM,roughnessmap_fragment:XM,roughnessmap_pars_fragment:qM,shadowmap_pars_fragment:YM,shadowmap_pars_vertex:$M,shadowmap_vertex:ZM,shadowmask_pars_fragment:JM,skinbase_vertex:KM,skinning_pars_vertex:jM,skinning_vertex:QM,skinnormal_vertex:tb,specularmap_fragment:eb,specularmap_pars_fragment:nb,tonemapping_fragment:ib,tonemapping_pars_fragment:sb,transmission_fragment:rb,transmission_pars_fragment:ob,
uv_pars_fragment:ab,uv_pars_vertex:lb,uv_vertex:cb,worldpos_vertex:hb,background_vert:ub,background_frag:fb,backgroundCube_vert:db,backgroundCube_frag:pb,cube_vert:mb,cube_frag:gb,depth_vert:vb,depth_frag:_b,distanceRGBA_vert:xb,distanceRGBA_frag:yb,equirect_vert:Mb,equirect_frag:bb,linedashed_vert:Sb,linedashed_frag:wb,meshbasic_vert:Eb,meshbasic_frag:Tb,meshlambert_vert:Ab,meshlambert_frag:Cb,meshmatcap_vert:Rb,
meshmatcap_frag:Pb,meshnormal_vert:Ib,meshnormal_frag:Lb,meshphong_vert:Db,meshphong_frag:Ub,meshphysical_vert:Fb,meshphysical_frag:Nb,meshtoon_vert:Ob,meshtoon_frag:Bb,points_vert:kb,points_frag:zb,shadow_vert:Vb,shadow_frag:Hb,sprite_vert:Gb,sprite_frag:Wb},St={common:{diffuse:{value:new ae(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{
value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},
lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new me(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{
value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ae(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{
direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},
shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},
pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ae(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{
value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ae(16777215)},opacity:{value:1},center:{value:new me(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},qi={basic:{uniforms:Pn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.
meshbasic_frag},lambert:{uniforms:Pn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.fog,St.lights,{emissive:{value:new ae(0)}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:Pn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,
St.fog,St.lights,{emissive:{value:new ae(0)},specular:{value:new ae(1118481)},shininess:{value:30}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:Pn([St.common,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.roughnessmap,St.metalnessmap,St.fog,St.lights,{emissive:{value:new ae(0)},roughness:{value:1},metalness:{value:0},
envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:Pn([St.common,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.gradientmap,St.fog,St.lights,{emissive:{value:new ae(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:Pn([St.common,St.bumpmap,St.normalmap,St.displacementmap,
St.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:Pn([St.points,St.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:Pn([St.common,St.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:Pn([St.common,St.displacementmap]),
vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:Pn([St.common,St.bumpmap,St.normalmap,St.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:Pn([St.sprite,St.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{
value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.
cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distanceRGBA:{uniforms:Pn([St.common,St.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distanceRGBA_vert,fragmentShader:ce.distanceRGBA_frag},shadow:{uniforms:Pn([St.lights,St.fog,{color:{
value:new ae(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};qi.physical={uniforms:Pn([qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new me(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},
clearcoatRoughnessMapTransform:{value:new oe},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ae(0)},sheenColorMap:{
value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new me},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{
value:0},attenuationColor:{value:new ae(0)},specularColor:{value:new ae(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new me},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.
meshphysical_frag};var rh={r:0,b:0,g:0},ur=new pi,Xb=new ge;function qb(i,t,e,n,s,r,o){let a=new ae(0),c=r===!0?0:1,l,h,u=null,f=0,d=null;function g(T){let y=T.isScene===!0?T.background:null;return y&&y.isTexture&&(y=(T.backgroundBlurriness>0?e:t).get(y)),y}function _(T){let y=!1,I=g(T);I===null?p(a,c):I&&I.isColor&&(p(I,1),y=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?n.buffers.color.
setClear(0,0,0,1,o):A==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||y)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(T,y){let I=g(y);I&&(I.isCubeTexture||I.mapping===Ma)?(h===void 0&&(h=new wn(new cs(1,1,1),new Ii({name:"BackgroundCubeMaterial",uniforms:hr(qi.backgroundCube.
uniforms),vertexShader:qi.backgroundCube.vertexShader,fragmentShader:qi.backgroundCube.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(A,D,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),
s.update(h)),ur.copy(y.backgroundRotation),ur.x*=-1,ur.y*=-1,ur.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(ur.y*=-1,ur.z*=-1),h.material.uniforms.envMap.value=I,h.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,h.
material.uniforms.backgroundRotation.value.setFromMatrix4(Xb.makeRotationFromEuler(ur)),h.material.toneMapped=ye.getTransfer(I.colorSpace)!==De,(u!==I||f!==I.version||d!==i.toneMapping)&&(h.material.needsUpdate=!0,u=I,f=I.version,d=i.toneMapping),h.layers.enableAll(),T.unshift(h,h.geometry,h.material,0,0,null)):I&&I.isTexture&&(l===void 0&&(l=new wn(new sr(2,2),new Ii({name:"BackgroundMaterial",uniforms:hr(
qi.background.uniforms),vertexShader:qi.background.vertexShader,fragmentShader:qi.background.fragmentShader,side:os,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(l)),l.material.uniforms.t2D.value=I,l.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,
l.material.toneMapped=ye.getTransfer(I.colorSpace)!==De,I.matrixAutoUpdate===!0&&I.updateMatrix(),l.material.uniforms.uvTransform.value.copy(I.matrix),(u!==I||f!==I.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=I,f=I.version,d=i.toneMapping),l.layers.enableAll(),T.unshift(l,l.geometry,l.material,0,0,null))}function p(T,y){T.getRGB(rh,pf(i)),n.buffers.color.setClear(rh.r,rh.g,rh.b,y,o)}
function b(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(T,y=1){a.set(T),c=y,p(a,c)},getClearAlpha:function(){return c},setClearAlpha:function(T){c=T,p(a,c)},render:_,addToRenderList:m,dispose:b}}function Yb(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),
n={},s=f(null),r=s,o=!1;function a(S,C,O,z,G){let X=!1,q=u(z,O,C);r!==q&&(r=q,l(r.object)),X=d(S,z,O,G),X&&g(S,z,O,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,y(S,C,O,z),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function c(){return i.createVertexArray()}function l(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,C,O){let z=O.
wireframe===!0,G=n[S.id];G===void 0&&(G={},n[S.id]=G);let X=G[C.id];X===void 0&&(X={},G[C.id]=X);let q=X[z];return q===void 0&&(q=f(c()),X[z]=q),q}function f(S){let C=[],O=[],z=[];for(let G=0;G<e;G++)C[G]=0,O[G]=0,z[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:O,attributeDivisors:z,object:S,attributes:{},index:null}}function d(S,C,O,z){let G=r.attributes,X=C.
attributes,q=0,Z=O.getAttributes();for(let j in Z)if(Z[j].location>=0){let ot=G[j],vt=X[j];if(vt===void 0&&(j==="instanceMatrix"&&S.instanceMatrix&&(vt=S.instanceMatrix),j==="instanceColor"&&S.instanceColor&&(vt=S.instanceColor)),ot===void 0||ot.attribute!==vt||vt&&ot.data!==vt.data)return!0;q++}return r.attributesNum!==q||r.index!==z}function g(S,C,O,z){let G={},X=C.attributes,q=0,Z=O.getAttributes();
for(let j in Z)if(Z[j].location>=0){let ot=X[j];ot===void 0&&(j==="instanceMatrix"&&S.instanceMatrix&&(ot=S.instanceMatrix),j==="instanceColor"&&S.instanceColor&&(ot=S.instanceColor));let vt={};vt.attribute=ot,ot&&ot.data&&(vt.data=ot.data),G[j]=vt,q++}r.attributes=G,r.attributesNum=q,r.index=z}function _(){let S=r.newAttributes;for(let C=0,O=S.length;C<O;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){
let O=r.newAttributes,z=r.enabledAttributes,G=r.attributeDivisors;O[S]=1,z[S]===0&&(i.enableVertexAttribArray(S),z[S]=1),G[S]!==C&&(i.vertexAttribDivisor(S,C),G[S]=C)}function b(){let S=r.newAttributes,C=r.enabledAttributes;for(let O=0,z=C.length;O<z;O++)C[O]!==S[O]&&(i.disableVertexAttribArray(O),C[O]=0)}function T(S,C,O,z,G,X,q){q===!0?i.vertexAttribIPointer(S,C,O,G,X):i.vertexAttribPointer(S,C,
O,z,G,X)}function y(S,C,O,z){_();let G=z.attributes,X=O.getAttributes(),q=C.defaultAttributeValues;for(let Z in X){let j=X[Z];if(j.location>=0){let rt=G[Z];if(rt===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(rt=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(rt=S.instanceColor)),rt!==void 0){let ot=rt.normalized,vt=rt.itemSize,xt=t.get(rt);if(xt===void 0)continue;let pt=xt.buffer,ee=xt.
type,Zt=xt.bytesPerElement,Q=ee===i.INT||ee===i.UNSIGNED_INT||rt.gpuType===Sc;if(rt.isInterleavedBufferAttribute){let tt=rt.data,Mt=tt.stride,Ot=rt.offset;if(tt.isInstancedInterleavedBuffer){for(let _t=0;_t<j.locationSize;_t++)p(j.location+_t,tt.meshPerAttribute);S.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let _t=0;_t<j.locationSize;_t++)
m(j.location+_t);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let _t=0;_t<j.locationSize;_t++)T(j.location+_t,vt/j.locationSize,ee,ot,Mt*Zt,(Ot+vt/j.locationSize*_t)*Zt,Q)}else{if(rt.isInstancedBufferAttribute){for(let tt=0;tt<j.locationSize;tt++)p(j.location+tt,rt.meshPerAttribute);S.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=rt.meshPerAttribute*rt.count)}else for(let tt=0;tt<
j.locationSize;tt++)m(j.location+tt);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let tt=0;tt<j.locationSize;tt++)T(j.location+tt,vt/j.locationSize,ee,ot,vt*Zt,vt/j.locationSize*tt*Zt,Q)}}else if(q!==void 0){let ot=q[Z];if(ot!==void 0)switch(ot.length){case 2:i.vertexAttrib2fv(j.location,ot);break;case 3:i.vertexAttrib3fv(j.location,ot);break;case 4:i.vertexAttrib4fv(j.location,ot);break;default:i.vertexAttrib1fv(
j.location,ot)}}}}b()}function I(){N();for(let S in n){let C=n[S];for(let O in C){let z=C[O];for(let G in z)h(z[G].object),delete z[G];delete C[O]}delete n[S]}}function A(S){if(n[S.id]===void 0)return;let C=n[S.id];for(let O in C){let z=C[O];for(let G in z)h(z[G].object),delete z[G];delete C[O]}delete n[S.id]}function D(S){for(let C in n){let O=n[C];if(O[S.id]===void 0)continue;let z=O[S.id];for(let G in z)
h(z[G].object),delete z[G];delete O[S.id]}}function N(){w(),o=!0,r!==s&&(r=s,l(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:w,dispose:I,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:_,enableAttribute:m,disableUnusedAttributes:b}}function $b(i,t,e){let n;function s(l){n=l}function r(l,h){i.drawArrays(n,l,h),e.update(
h,n,1)}function o(l,h,u){u!==0&&(i.drawArraysInstanced(n,l,h,u),e.update(h,n,u))}function a(l,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,h,0,u);let d=0;for(let g=0;g<u;g++)d+=h[g];e.update(d,n,1)}function c(l,h,u,f){if(u===0)return;let d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<l.length;g++)o(l[g],h[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(n,l,0,h,0,f,
0,u);let g=0;for(let _=0;_<u;_++)g+=h[_]*f[_];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=c}function Zb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){
return!(D!==gi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let N=D===xo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Li&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Di&&!N)}function c(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(
i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(console.warn("THREE.WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.
logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(
i.MAX_FRAGMENT_UNIFORM_VECTORS),I=g>0,A=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:b,maxVaryings:T,maxFragmentUniforms:y,vertexTextures:I,maxSamples:A}}
function Jb(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Vi,a=new oe,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,
_=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):l();else{let b=r?0:n,T=b*4,y=p.clippingState||null;c.value=y,y=h(g,f,T,d);for(let I=0;I!==T;++I)y[I]=e[I];p.clippingState=y,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=b}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,g){let _=u!==null?
u.length:0,m=null;if(_!==0){if(m=c.value,g!==!0||m===null){let p=d+_*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,y=d;T!==_;++T,y+=4)o.copy(u[T]).applyMatrix4(b,a),o.normal.toArray(m,y),m[y+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}function Kb(i){let t=new WeakMap;function e(o,a){return a===yc?o.
mapping=lr:a===Mc&&(o.mapping=cr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===yc||a===Mc)if(t.has(o)){let c=t.get(o).texture;return e(c,o.mapping)}else{let c=o.image;if(c&&c.height>0){let l=new Jl(c.height);return l.fromEquirectangularTexture(i,o),t.set(o,l),o.addEventListener("dispose",s),e(l.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener(
"dispose",s);let c=t.get(a);c!==void 0&&(t.delete(a),c.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var So=4,zg=[.125,.215,.35,.446,.526,.582],pr=20,_f=new ar,Vg=new ae,xf=null,yf=0,Mf=0,bf=!1,dr=(1+Math.sqrt(5))/2,bo=1/dr,Hg=[new W(-dr,bo,0),new W(dr,bo,0),new W(-bo,0,dr),new W(bo,0,dr),new W(0,dr,-bo),new W(0,dr,bo),new W(-1,1,-1),new W(1,1,-1),new W(-1,1,1),new W(1,1,1)],jb=new W,
lh=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=jb}=r;xf=this._renderer.getRenderTarget(),yf=this._renderer.getActiveCubeFace(),
Mf=this._renderer.getActiveMipmapLevel(),bf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let c=this._allocateTargets();return c.depthBuffer=!0,this._sceneToCubeUV(t,n,s,c,a),e>0&&this._blur(c,0,0,e),this._applyPMREM(c),this._cleanup(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){
this._cubemapMaterial===null&&(this._cubemapMaterial=Xg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){
this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(xf,yf,Mf),this._renderer.xr.enabled=bf,t.scissorTest=!1,oh(t,0,0,t.width,
t.height)}_fromTexture(t,e){t.mapping===lr||t.mapping===cr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),xf=this._renderer.getRenderTarget(),yf=this._renderer.getActiveCubeFace(),Mf=this._renderer.getActiveMipmapLevel(),bf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(
t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Pi,minFilter:Pi,generateMipmaps:!1,type:xo,format:gi,colorSpace:nr,depthBuffer:!1},s=Gg(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=
Gg(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=Qb(r)),this._blurMaterial=tS(r,t,e)}return s}_compileMaterial(t){let e=new wn(this._lodPlanes[0],t);this._renderer.compile(e,_f)}_sceneToCubeUV(t,e,n,s,r){let c=new Rn(90,1,e,n),l=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],u=this._renderer,f=u.autoClear,d=u.toneMapping;u.getClearColor(Vg),u.toneMapping=us,
u.autoClear=!1,u.state.buffers.depth.getReversed()&&(u.setRenderTarget(s),u.clearDepth(),u.setRenderTarget(null));let _=new ir({name:"PMREM.Background",side:zn,depthWrite:!1,depthTest:!1}),m=new wn(new cs,_),p=!1,b=t.background;b?b.isColor&&(_.color.copy(b),t.background=null,p=!0):(_.color.copy(Vg),p=!0);for(let T=0;T<6;T++){let y=T%3;y===0?(c.up.set(0,l[T],0),c.position.set(r.x,r.y,r.z),c.lookAt(
r.x+h[T],r.y,r.z)):y===1?(c.up.set(0,0,l[T]),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y+h[T],r.z)):(c.up.set(0,l[T],0),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y,r.z+h[T]));let I=this._cubeSize;oh(s,y*I,T>2?I:0,I,I),u.setRenderTarget(s),p&&u.render(m,c),u.render(t,c)}m.geometry.dispose(),m.material.dispose(),u.toneMapping=d,u.autoClear=f,t.background=b}_textureToCubeUV(t,e){let n=this._renderer,
s=t.mapping===lr||t.mapping===cr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xg()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Wg());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new wn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let c=this._cubeSize;oh(e,0,0,3*c,2*c),n.setRenderTarget(
e),n.render(o,_f)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Hg[(s-r-1)%Hg.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"lo\
ngitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let c=this._renderer,l=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new wn(this._lodPlanes[s],l),f=l.uniforms,d=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*pr-1),_=r/g,m=isFinite(r)?1+Math.floor(h*_):pr;m>pr&&console.warn(`sigmaRadians, ${r}, i\
s too large and will clip, as it requested ${m} samples when the maximum is set to ${pr}`);let p=[],b=0;for(let D=0;D<pr;++D){let N=D/_,w=Math.exp(-N*N/2);p.push(w),D===0?b+=w:D<m&&(b+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/b;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=
T-n;let y=this._sizeLods[s],I=3*y*(s>T-So?s-T+So:0),A=4*(this._cubeSize-y);oh(e,I,A,3*y,2*y),c.setRenderTarget(e),c.render(u,_f)}};function Qb(i){let t=[],e=[],n=[],s=i,r=i-So+1+zg.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let c=1/a;o>i-So?c=zg[o-i+So-1]:o===0&&(c=0),n.push(c);let l=1/(a-2),h=-l,u=1+l,f=[h,h,u,h,u,u,h,h,u,u,h,u],d=6,g=6,_=3,m=2,p=1,b=new Float32Array(_*g*d),T=new Float32Array(
m*g*d),y=new Float32Array(p*g*d);for(let A=0;A<d;A++){let D=A%3*2/3-1,N=A>2?0:-1,w=[D,N,0,D+2/3,N,0,D+2/3,N+1,0,D,N,0,D+2/3,N+1,0,D,N+1,0];b.set(w,_*g*A),T.set(f,m*g*A);let S=[A,A,A,A,A,A];y.set(S,p*g*A)}let I=new en;I.setAttribute("position",new Xn(b,_)),I.setAttribute("uv",new Xn(T,m)),I.setAttribute("faceIndex",new Xn(y,p)),t.push(I),s>So&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function Gg(i,t,e){
let n=new Hi(i,t,e);return n.texture.mapping=Ma,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function oh(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function tS(i,t,e){let n=new Float32Array(pr),s=new W(0,1,0);return new Ii({name:"SphericalGaussianBlur",defines:{n:pr,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},
weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Lf(),fragmentShader:`

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
		`,blending:hs,depthTest:!1,depthWrite:!1})}function Wg(){return new Ii({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Lf(),fragmentShader:`

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
		`,blending:hs,depthTest:!1,depthWrite:!1})}function Xg(){return new Ii({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Lf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:hs,depthTest:!1,depthWrite:!1})}function Lf(){return`

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
	`}function eS(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let c=a.mapping,l=c===yc||c===Mc,h=c===lr||c===cr;if(l||h){let u=t.get(a),f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new lh(i)),u=l?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;
{let d=a.image;return l&&d&&d.height>0||h&&d&&s(d)?(e===null&&(e=new lh(i)),u=l?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let c=0,l=6;for(let h=0;h<l;h++)a[h]!==void 0&&c++;return c===l}function r(a){let c=a.target;c.removeEventListener("dispose",r);let l=t.get(c);l!==void 0&&(t.
delete(c),l.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function nS(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension(
"EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension(
"WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){
let s=e(n);return s===null&&no("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function iS(i,t,e,n){let s={},r=new WeakMap;function o(u){let f=u.target;f.index!==null&&t.remove(f.index);for(let g in f.attributes)t.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let d=r.get(f);d&&(t.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===
!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function c(u){let f=u.attributes;for(let d in f)t.update(f[d],i.ARRAY_BUFFER)}function l(u){let f=[],d=u.index,g=u.attributes.position,_=0;if(d!==null){let b=d.array;_=d.version;for(let T=0,y=b.length;T<y;T+=3){let I=b[T+0],A=b[T+1],D=b[T+2];
f.push(I,A,A,D,D,I)}}else if(g!==void 0){let b=g.array;_=g.version;for(let T=0,y=b.length/3-1;T<y;T+=3){let I=T+0,A=T+1,D=T+2;f.push(I,A,A,D,D,I)}}else return;let m=new(df(f)?ra:sa)(f,1);m.version=_;let p=r.get(u);p&&t.remove(p),r.set(u,m)}function h(u){let f=r.get(u);if(f){let d=u.index;d!==null&&f.version<d.version&&l(u)}else l(u);return r.get(u)}return{get:a,update:c,getWireframeAttribute:h}}function sS(i,t,e){
let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*o),e.update(d,n,1)}function l(f,d,g){g!==0&&(i.drawElementsInstanced(n,d,r,f*o,g),e.update(d,n,g))}function h(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,n,1)}function u(f,d,g,_){if(g===0)return;let m=t.
get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)l(f[p]/o,d[p],_[p]);else{m.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,_,0,g);let p=0;for(let b=0;b<g;b++)p+=d[b]*_[b];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function rS(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,
points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,
programs:null,autoReset:!0,reset:s,update:n}}function oS(i,t,e){let n=new WeakMap,s=new je;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let w=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.
position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],T=0;d===!0&&(T=1),g===!0&&(T=2),_===!0&&(T=3);let y=a.attributes.position.count*T,I=1;y>t.maxTextureSize&&(I=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let A=new Float32Array(y*I*4*u),D=new ia(A,y,I,u);D.type=Di,
D.needsUpdate=!0;let N=T*4;for(let S=0;S<u;S++){let C=m[S],O=p[S],z=b[S],G=y*I*4*S;for(let X=0;X<C.count;X++){let q=X*N;d===!0&&(s.fromBufferAttribute(C,X),A[G+q+0]=s.x,A[G+q+1]=s.y,A[G+q+2]=s.z,A[G+q+3]=0),g===!0&&(s.fromBufferAttribute(O,X),A[G+q+4]=s.x,A[G+q+5]=s.y,A[G+q+6]=s.z,A[G+q+7]=0),_===!0&&(s.fromBufferAttribute(z,X),A[G+q+8]=s.x,A[G+q+9]=s.y,A[G+q+10]=s.z,A[G+q+11]=z.itemSize===4?s.w:1)}}
f={count:u,texture:D,size:new me(y,I)},n.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<l.length;_++)d+=l[_];let g=a.morphTargetsRelative?1:1-d;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().
setValue(i,"morphTargetsTexture",f.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function aS(i,t,e,n){let s=new WeakMap;function r(c){let l=n.render.frame,h=c.geometry,u=t.get(c,h);if(s.get(u)!==l&&(t.update(u),s.set(u,l)),c.isInstancedMesh&&(c.hasEventListener("dispose",a)===!1&&c.addEventListener("dispose",a),s.get(c)!==l&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),
c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,l))),c.isSkinnedMesh){let f=c.skeleton;s.get(f)!==l&&(f.update(),s.set(f,l))}return u}function o(){s=new WeakMap}function a(c){let l=c.target;l.removeEventListener("dispose",a),e.remove(l.instanceMatrix),l.instanceColor!==null&&e.remove(l.instanceColor)}return{update:r,dispose:o}}var h0=new Yn,qg=new ua(1,1),u0=new ia,f0=new $l,
d0=new aa,Yg=[],$g=[],Zg=new Float32Array(16),Jg=new Float32Array(9),Kg=new Float32Array(4);function Eo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Yg[s];if(r===void 0&&(r=new Float32Array(s),Yg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function cn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}
function hn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function hh(i,t){let e=$g[t];e===void 0&&(e=new Int32Array(t),$g[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function lS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function cS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(
e,t))return;i.uniform2fv(this.addr,t),hn(e,t)}}function hS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(cn(e,t))return;i.uniform3fv(this.addr,t),hn(e,t)}}function uS(i,t){let e=this.
cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4fv(this.addr,t),hn(e,t)}}function fS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;Kg.set(n),i.uniformMatrix2fv(this.addr,!1,Kg),hn(
e,n)}}function dS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;Jg.set(n),i.uniformMatrix3fv(this.addr,!1,Jg),hn(e,n)}}function pS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(cn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),hn(e,t)}else{if(cn(e,n))return;Zg.set(n),i.uniformMatrix4fv(this.addr,!1,Zg),hn(
e,n)}}function mS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function gS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(e,t))return;i.uniform2iv(this.addr,t),hn(e,t)}}function vS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.
x,e[1]=t.y,e[2]=t.z);else{if(cn(e,t))return;i.uniform3iv(this.addr,t),hn(e,t)}}function _S(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4iv(this.addr,t),hn(e,t)}}function xS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function yS(i,t){
let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(cn(e,t))return;i.uniform2uiv(this.addr,t),hn(e,t)}}function MS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(cn(e,t))return;i.uniform3uiv(this.addr,t),hn(e,t)}}function bS(i,t){let e=this.
cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(cn(e,t))return;i.uniform4uiv(this.addr,t),hn(e,t)}}function SS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(qg.compareFunction=uf,r=qg):r=h0,e.setTexture2D(
t||r,s)}function wS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||f0,s)}function ES(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||d0,s)}function TS(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||u0,
s)}function AS(i){switch(i){case 5126:return lS;case 35664:return cS;case 35665:return hS;case 35666:return uS;case 35674:return fS;case 35675:return dS;case 35676:return pS;case 5124:case 35670:return mS;case 35667:case 35671:return gS;case 35668:case 35672:return vS;case 35669:case 35673:return _S;case 5125:return xS;case 36294:return yS;case 36295:return MS;case 36296:return bS;case 35678:case 36198:case 36298:case 36306:case 35682:
return SS;case 35679:case 36299:case 36307:return wS;case 35680:case 36300:case 36308:case 36293:return ES;case 36289:case 36303:case 36311:case 36292:return TS}}function CS(i,t){i.uniform1fv(this.addr,t)}function RS(i,t){let e=Eo(t,this.size,2);i.uniform2fv(this.addr,e)}function PS(i,t){let e=Eo(t,this.size,3);i.uniform3fv(this.addr,e)}function IS(i,t){let e=Eo(t,this.size,4);i.uniform4fv(this.addr,
e)}function LS(i,t){let e=Eo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function DS(i,t){let e=Eo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function US(i,t){let e=Eo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function FS(i,t){i.uniform1iv(this.addr,t)}function NS(i,t){i.uniform2iv(this.addr,t)}function OS(i,t){i.uniform3iv(this.addr,t)}function BS(i,t){i.uniform4iv(this.addr,
t)}function kS(i,t){i.uniform1uiv(this.addr,t)}function zS(i,t){i.uniform2uiv(this.addr,t)}function VS(i,t){i.uniform3uiv(this.addr,t)}function HS(i,t){i.uniform4uiv(this.addr,t)}function GS(i,t,e){let n=this.cache,s=t.length,r=hh(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||h0,r[o])}function WS(i,t,e){let n=this.cache,s=t.length,r=hh(e,s);cn(n,r)||(i.
uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||f0,r[o])}function XS(i,t,e){let n=this.cache,s=t.length,r=hh(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||d0,r[o])}function qS(i,t,e){let n=this.cache,s=t.length,r=hh(e,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||u0,r[o])}
function YS(i){switch(i){case 5126:return CS;case 35664:return RS;case 35665:return PS;case 35666:return IS;case 35674:return LS;case 35675:return DS;case 35676:return US;case 5124:case 35670:return FS;case 35667:case 35671:return NS;case 35668:case 35672:return OS;case 35669:case 35673:return BS;case 5125:return kS;case 36294:return zS;case 36295:return VS;case 36296:return HS;case 35678:case 36198:case 36298:case 36306:case 35682:
return GS;case 35679:case 36299:case 36307:return WS;case 35680:case 36300:case 36308:case 36293:return XS;case 36289:case 36303:case 36311:case 36292:return qS}}var wf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=AS(e.type)}},Ef=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=YS(e.type)}},Tf=class{constructor(t){
this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Sf=/(\w+)(\])?(\[|\.)?/g;function jg(i,t){i.seq.push(t),i.map[t.id]=t}function $S(i,t,e){let n=i.name,s=n.length;for(Sf.lastIndex=0;;){let r=Sf.exec(n),o=Sf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){jg(e,l===void 0?new wf(a,
i,t):new Ef(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Tf(a),jg(e,u)),e=u}}}var wo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);$S(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.
setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Qg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var ZS=37297,JS=0;function KS(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var t0=new oe;function jS(i){ye._getMatrix(t0,ye.workingColorSpace,i);let t=`mat3( ${t0.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(i)){case ta:return[t,"LinearTransferOETF"];case De:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function e0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.
getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+KS(i.getShaderSource(t),a)}else return r}function QS(i,t){let e=jS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function t1(i,t){let e;switch(t){case vg:e="Linear";break;case _g:e="Reinhard";break;case xg:e="Cineon";break;case yg:e="ACESFilmic";break;case bg:e="AgX";break;case Sg:e="Neutral";break;case Mg:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ah=new W;function e1(){ye.getLuminanceCoefficients(
ah);let i=ah.x.toFixed(4),t=ah.y.toFixed(4),e=ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function n1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ca).join(`
`)}function i1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function s1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ca(i){return i!==""}function n0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;
return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,
t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function i0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var r1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Af(i){return i.replace(r1,a1)}var o1=new Map;function a1(i,t){
let e=ce[t];if(e===void 0){let n=o1.get(t);if(n!==void 0)e=ce[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Af(e)}var l1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function s0(i){return i.
replace(l1,c1)}function c1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function r0(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}function h1(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===ju?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===fc?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Xi&&(t="SHADOWMAP_TYPE_VSM"),t}function u1(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case lr:case cr:t="ENVMAP_TYPE_CUBE";break;case Ma:t="ENVMAP_TYPE_CUBE_UV";break}return t}function f1(i){let t="\
ENVMAP_MODE_REFLECTION";return i.envMap&&i.envMapMode===cr&&(t="ENVMAP_MODE_REFRACTION"),t}function d1(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case vo:t="ENVMAP_BLENDING_MULTIPLY";break;case mg:t="ENVMAP_BLENDING_MIX";break;case gg:t="ENVMAP_BLENDING_ADD";break}return t}function p1(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/
(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function m1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=h1(e),l=u1(e),h=f1(e),u=d1(e),f=p1(e),d=n1(e),g=i1(r),_=s.createProgram(),m,p,b=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Ca).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Ca).join(`
`),p.length>0&&(p+=`
`)):(m=[r0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#defin\
e USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTS\
PACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEM\
AP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",
e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#de\
fine AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?
"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDE\
SCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV\
 "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#defin\
e USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MO\
RPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE\
_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_\
MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined\
( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ca).join(`
`),p=[r0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",f?"#define CUBEUV_\
TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?
"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCEN\
CE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALP\
HAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?
"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDE\
D":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHM\
IC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==us?"#define TONE_MAPPING":"",e.toneMapping!==us?ce.tonemapping_pars_fragment:"",e.toneMapping!==us?t1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,
QS("linearToOutputTexel",e.outputColorSpace),e1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ca).join(`
`)),o=Af(o),o=n0(o,e),o=i0(o,e),a=Af(a),a=n0(a,e),a=i0(a,e),o=s0(o),a=s0(a),e.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===ff?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===ff?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEX\
T textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let T=b+m+o,y=b+p+a,I=Qg(s,s.VERTEX_SHADER,T),A=Qg(s,s.FRAGMENT_SHADER,y);s.attachShader(_,I),s.attachShader(_,A),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function D(C){if(i.debug.checkShaderErrors){let O=s.getProgramInfoLog(_)||"",z=s.getShaderInfoLog(I)||"",G=s.getShaderInfoLog(A)||
"",X=O.trim(),q=z.trim(),Z=G.trim(),j=!0,rt=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(j=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,I,A);else{let ot=e0(s,I,"vertex"),vt=e0(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+X+`
`+ot+`
`+vt)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(q===""||Z==="")&&(rt=!1);rt&&(C.diagnostics={runnable:j,programLog:X,vertexShader:{log:q,prefix:m},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(I),s.deleteShader(A),N=new wo(s,_),w=s1(s,_)}let N;this.getUniforms=function(){return N===void 0&&D(this),N};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.
rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(_,ZS)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=JS++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=I,this.fragmentShader=A,this}var g1=0,Cf=class{constructor(){
this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);
return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(
t);return n===void 0&&(n=new Rf(t),e.set(t,n)),n}},Rf=class{constructor(t){this.id=g1++,this.code=t,this.usedTimes=0}};function v1(i,t,e,n,s,r,o){let a=new ro,c=new Cf,l=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures,d=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"\
phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function _(w){return l.add(w),w===0?"uv":`uv${w}`}function m(w,S,C,O,z){let G=O.fog,X=z.geometry,q=w.isMeshStandardMaterial?O.environment:null,Z=(w.isMeshStandardMaterial?
e:t).get(w.envMap||q),j=Z&&Z.mapping===Ma?Z.image.height:null,rt=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));let ot=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,vt=ot!==void 0?ot.length:0,xt=0;X.morphAttributes.position!==void 0&&(xt=
1),X.morphAttributes.normal!==void 0&&(xt=2),X.morphAttributes.color!==void 0&&(xt=3);let pt,ee,Zt,Q;if(rt){let Me=qi[rt];pt=Me.vertexShader,ee=Me.fragmentShader}else pt=w.vertexShader,ee=w.fragmentShader,c.update(w),Zt=c.getVertexShaderID(w),Q=c.getFragmentShaderID(w);let tt=i.getRenderTarget(),Mt=i.state.buffers.depth.getReversed(),Ot=z.isInstancedMesh===!0,_t=z.isBatchedMesh===!0,Qt=!!w.map,Pe=!!w.
matcap,U=!!Z,xe=!!w.aoMap,Kt=!!w.lightMap,qt=!!w.bumpMap,Ft=!!w.normalMap,Ie=!!w.displacementMap,Pt=!!w.emissiveMap,Xt=!!w.metalnessMap,He=!!w.roughnessMap,Ee=w.anisotropy>0,P=w.clearcoat>0,x=w.dispersion>0,F=w.iridescence>0,J=w.sheen>0,nt=w.transmission>0,et=Ee&&!!w.anisotropyMap,Nt=P&&!!w.clearcoatMap,ht=P&&!!w.clearcoatNormalMap,Lt=P&&!!w.clearcoatRoughnessMap,At=F&&!!w.iridescenceMap,at=F&&!!w.
iridescenceThicknessMap,gt=J&&!!w.sheenColorMap,zt=J&&!!w.sheenRoughnessMap,kt=!!w.specularMap,yt=!!w.specularColorMap,te=!!w.specularIntensityMap,B=nt&&!!w.transmissionMap,ut=nt&&!!w.thicknessMap,dt=!!w.gradientMap,It=!!w.alphaMap,ct=w.alphaTest>0,st=!!w.alphaHash,Bt=!!w.extensions,ne=us;w.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(ne=i.toneMapping);let Ue={shaderID:rt,shaderType:w.type,
shaderName:w.name,vertexShader:pt,fragmentShader:ee,defines:w.defines,customVertexShaderID:Zt,customFragmentShaderID:Q,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:_t,batchingColor:_t&&z._colorsTexture!==null,instancing:Ot,instancingColor:Ot&&z.instanceColor!==null,instancingMorph:Ot&&z.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:tt===
null?i.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:nr,alphaToCoverage:!!w.alphaToCoverage,map:Qt,matcap:Pe,envMap:U,envMapMode:U&&Z.mapping,envMapCubeUVHeight:j,aoMap:xe,lightMap:Kt,bumpMap:qt,normalMap:Ft,displacementMap:f&&Ie,emissiveMap:Pt,normalMapObjectSpace:Ft&&w.normalMapType===Ag,normalMapTangentSpace:Ft&&w.normalMapType===sh,metalnessMap:Xt,roughnessMap:He,anisotropy:Ee,
anisotropyMap:et,clearcoat:P,clearcoatMap:Nt,clearcoatNormalMap:ht,clearcoatRoughnessMap:Lt,dispersion:x,iridescence:F,iridescenceMap:At,iridescenceThicknessMap:at,sheen:J,sheenColorMap:gt,sheenRoughnessMap:zt,specularMap:kt,specularColorMap:yt,specularIntensityMap:te,transmission:nt,transmissionMap:B,thicknessMap:ut,gradientMap:dt,opaque:w.transparent===!1&&w.blending===tr&&w.alphaToCoverage===!1,
alphaMap:It,alphaTest:ct,alphaHash:st,combine:w.combine,mapUv:Qt&&_(w.map.channel),aoMapUv:xe&&_(w.aoMap.channel),lightMapUv:Kt&&_(w.lightMap.channel),bumpMapUv:qt&&_(w.bumpMap.channel),normalMapUv:Ft&&_(w.normalMap.channel),displacementMapUv:Ie&&_(w.displacementMap.channel),emissiveMapUv:Pt&&_(w.emissiveMap.channel),metalnessMapUv:Xt&&_(w.metalnessMap.channel),roughnessMapUv:He&&_(w.roughnessMap.
channel),anisotropyMapUv:et&&_(w.anisotropyMap.channel),clearcoatMapUv:Nt&&_(w.clearcoatMap.channel),clearcoatNormalMapUv:ht&&_(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Lt&&_(w.clearcoatRoughnessMap.channel),iridescenceMapUv:At&&_(w.iridescenceMap.channel),iridescenceThicknessMapUv:at&&_(w.iridescenceThicknessMap.channel),sheenColorMapUv:gt&&_(w.sheenColorMap.channel),sheenRoughnessMapUv:zt&&
_(w.sheenRoughnessMap.channel),specularMapUv:kt&&_(w.specularMap.channel),specularColorMapUv:yt&&_(w.specularColorMap.channel),specularIntensityMapUv:te&&_(w.specularIntensityMap.channel),transmissionMapUv:B&&_(w.transmissionMap.channel),thicknessMapUv:ut&&_(w.thicknessMap.channel),alphaMapUv:It&&_(w.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(Ft||Ee),vertexColors:w.vertexColors,vertexAlphas:w.
vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!X.attributes.uv&&(Qt||It),fog:!!G,useFog:w.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:w.flatShading===!0&&w.wireframe===!1,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:z.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.
morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:vt,morphTextureStride:xt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.
length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:ne,decodeVideoTexture:Qt&&w.map.isVideoTexture===!0&&ye.getTransfer(w.map.colorSpace)===
De,decodeVideoTextureEmissive:Pt&&w.emissiveMap.isVideoTexture===!0&&ye.getTransfer(w.emissiveMap.colorSpace)===De,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===mi,flipSided:w.side===zn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Bt&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_dis\
tance"),extensionMultiDraw:(Bt&&w.extensions.multiDraw===!0||_t)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return Ue.vertexUv1s=l.has(1),Ue.vertexUv2s=l.has(2),Ue.vertexUv3s=l.has(3),l.clear(),Ue}function p(w){let S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(
w.customFragmentShaderID)),w.defines!==void 0)for(let C in w.defines)S.push(C),S.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(b(S,w),T(S,w),S.push(i.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function b(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),
w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),
w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),
w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(
3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&
a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),
S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}
function y(w){let S=g[w.type],C;if(S){let O=qi[S];C=Bg.clone(O.uniforms)}else C=w.uniforms;return C}function I(w,S){let C;for(let O=0,z=h.length;O<z;O++){let G=h[O];if(G.cacheKey===S){C=G,++C.usedTimes;break}}return C===void 0&&(C=new m1(i,S,w,r),h.push(C)),C}function A(w){if(--w.usedTimes===0){let S=h.indexOf(w);h[S]=h[h.length-1],h.pop(),w.destroy()}}function D(w){c.remove(w)}function N(){c.dispose()}
return{getParameters:m,getProgramCacheKey:p,getUniforms:y,acquireProgram:I,releaseProgram:A,releaseShaderCache:D,programs:h,dispose:N}}function _1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function x1(i,t){
return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function o0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function a0(){let i=[],t=0,e=[],
n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u,f,d,g,_,m){let p=i[t];return p===void 0?(p={id:u.id,object:u,geometry:f,material:d,groupOrder:g,renderOrder:u.renderOrder,z:_,group:m},i[t]=p):(p.id=u.id,p.object=u,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=u.renderOrder,p.z=_,p.group=m),t++,p}function a(u,f,d,g,_,m){let p=o(u,f,d,g,_,m);d.transmission>0?n.push(p):
d.transparent===!0?s.push(p):e.push(p)}function c(u,f,d,g,_,m){let p=o(u,f,d,g,_,m);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function l(u,f){e.length>1&&e.sort(u||x1),n.length>1&&n.sort(f||o0),s.length>1&&s.sort(f||o0)}function h(){for(let u=t,f=i.length;u<f;u++){let d=i[u];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}
return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:c,finish:h,sort:l}}function y1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new a0,i.set(n,[o])):s>=r.length?(o=new a0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function M1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"Directi\
onalLight":e={direction:new W,color:new ae};break;case"SpotLight":e={position:new W,direction:new W,color:new ae,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new ae,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new ae,groundColor:new ae};break;case"RectAreaLight":e={color:new ae,position:new W,halfWidth:new W,halfHeight:new W};
break}return i[t.id]=e,e}}}function b1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new me};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new me};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,
shadowNormalBias:0,shadowRadius:1,shadowMapSize:new me,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var S1=0;function w1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function E1(i){let t=new M1,e=b1(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,
numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<
9;l++)n.probe.push(new W);let s=new W,r=new ge,o=new ge;function a(l){let h=0,u=0,f=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let d=0,g=0,_=0,m=0,p=0,b=0,T=0,y=0,I=0,A=0,D=0;l.sort(w1);for(let w=0,S=l.length;w<S;w++){let C=l[w],O=C.color,z=C.intensity,G=C.distance,X=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=O.r*z,u+=O.g*z,f+=O.b*z;else if(C.isLightProbe){for(let q=0;q<
9;q++)n.probe[q].addScaledVector(C.sh.coefficients[q],z);D++}else if(C.isDirectionalLight){let q=t.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let Z=C.shadow,j=e.get(C);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,n.directionalShadow[d]=j,n.directionalShadowMap[d]=X,n.directionalShadowMatrix[d]=
C.shadow.matrix,b++}n.directional[d]=q,d++}else if(C.isSpotLight){let q=t.get(C);q.position.setFromMatrixPosition(C.matrixWorld),q.color.copy(O).multiplyScalar(z),q.distance=G,q.coneCos=Math.cos(C.angle),q.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),q.decay=C.decay,n.spot[_]=q;let Z=C.shadow;if(C.map&&(n.spotLightMap[I]=C.map,I++,Z.updateMatrices(C),C.castShadow&&A++),n.spotLightMatrix[_]=Z.matrix,
C.castShadow){let j=e.get(C);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,n.spotShadow[_]=j,n.spotShadowMap[_]=X,y++}_++}else if(C.isRectAreaLight){let q=t.get(C);q.color.copy(O).multiplyScalar(z),q.halfWidth.set(C.width*.5,0,0),q.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=q,m++}else if(C.isPointLight){let q=t.
get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),q.distance=C.distance,q.decay=C.decay,C.castShadow){let Z=C.shadow,j=e.get(C);j.shadowIntensity=Z.intensity,j.shadowBias=Z.bias,j.shadowNormalBias=Z.normalBias,j.shadowRadius=Z.radius,j.shadowMapSize=Z.mapSize,j.shadowCameraNear=Z.camera.near,j.shadowCameraFar=Z.camera.far,n.pointShadow[g]=j,n.pointShadowMap[g]=X,n.pointShadowMatrix[g]=C.
shadow.matrix,T++}n.point[g]=q,g++}else if(C.isHemisphereLight){let q=t.get(C);q.skyColor.copy(C.color).multiplyScalar(z),q.groundColor.copy(C.groundColor).multiplyScalar(z),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=St.LTC_FLOAT_1,n.rectAreaLTC2=St.LTC_FLOAT_2):(n.rectAreaLTC1=St.LTC_HALF_1,n.rectAreaLTC2=St.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=
f;let N=n.hash;(N.directionalLength!==d||N.pointLength!==g||N.spotLength!==_||N.rectAreaLength!==m||N.hemiLength!==p||N.numDirectionalShadows!==b||N.numPointShadows!==T||N.numSpotShadows!==y||N.numSpotMaps!==I||N.numLightProbes!==D)&&(n.directional.length=d,n.spot.length=_,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.
length=T,n.pointShadowMap.length=T,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=y+I-A,n.spotLightMap.length=I,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=D,N.directionalLength=d,N.pointLength=g,N.spotLength=_,N.rectAreaLength=m,N.hemiLength=p,N.numDirectionalShadows=b,N.numPointShadows=T,N.numSpotShadows=
y,N.numSpotMaps=I,N.numLightProbes=D,n.version=S1++)}function c(l,h){let u=0,f=0,d=0,g=0,_=0,m=h.matrixWorldInverse;for(let p=0,b=l.length;p<b;p++){let T=l[p];if(T.isDirectionalLight){let y=n.directional[u];y.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),u++}else if(T.isSpotLight){let y=n.spot[d];y.
position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(m),y.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),d++}else if(T.isRectAreaLight){let y=n.rectArea[g];y.position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.
extractRotation(r),y.halfWidth.set(T.width*.5,0,0),y.halfHeight.set(0,T.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(T.matrixWorld),y.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){let y=n.hemi[_];y.direction.setFromMatrixPosition(T.matrixWorld),y.direction.transformDirection(m),_++}}}
return{setup:a,setupView:c,state:n}}function l0(i){let t=new E1(i),e=[],n=[];function s(h){l.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function c(h){t.setupView(e,h)}let l={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:l,setupLights:a,setupLightsView:c,pushLight:r,pushShadow:o}}function T1(i){
let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new l0(i),t.set(s,[a])):r>=o.length?(a=new l0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var A1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,C1=`uniform sampler2D shadow_pass;
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
}`;function R1(i,t,e){let n=new ao,s=new me,r=new me,o=new je,a=new tc({depthPacking:Tg}),c=new ec,l={},h=e.maxTextureSize,u={[os]:zn,[zn]:os,[mi]:mi},f=new Ii({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new me},radius:{value:4}},vertexShader:A1,fragmentShader:C1}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new en;g.setAttribute("position",new Xn(new Float32Array(
[-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new wn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ju;let p=this.type;this.render=function(A,D,N){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;let w=i.getRenderTarget(),S=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),O=i.state;O.setBlending(hs),O.buffers.depth.getReversed()===!0?O.buffers.color.
setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=p!==Xi&&this.type===Xi,G=p===Xi&&this.type!==Xi;for(let X=0,q=A.length;X<q;X++){let Z=A[X],j=Z.shadow;if(j===void 0){console.warn("THREE.WebGLShadowMap:",Z,"has no shadow.");continue}if(j.autoUpdate===!1&&j.needsUpdate===!1)continue;s.copy(j.mapSize);let rt=j.getFrameExtents();if(s.multiply(rt),
r.copy(j.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/rt.x),s.x=r.x*rt.x,j.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/rt.y),s.y=r.y*rt.y,j.mapSize.y=r.y)),j.map===null||z===!0||G===!0){let vt=this.type!==Xi?{minFilter:qn,magFilter:qn}:{};j.map!==null&&j.map.dispose(),j.map=new Hi(s.x,s.y,vt),j.map.texture.name=Z.name+".shadowMap",j.camera.updateProjectionMatrix()}i.setRenderTarget(j.map),i.clear();
let ot=j.getViewportCount();for(let vt=0;vt<ot;vt++){let xt=j.getViewport(vt);o.set(r.x*xt.x,r.y*xt.y,r.x*xt.z,r.y*xt.w),O.viewport(o),j.updateMatrices(Z,vt),n=j.getFrustum(),y(D,N,j.camera,Z,this.type)}j.isPointLightShadow!==!0&&this.type===Xi&&b(j,N),j.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(w,S,C)};function b(A,D){let N=t.update(_);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.
defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Hi(s.x,s.y)),f.uniforms.shadow_pass.value=A.map.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(D,null,N,f,_,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.
resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(D,null,N,d,_,null)}function T(A,D,N,w){let S=null,C=N.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)S=C;else if(S=N.isPointLight===!0?c:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&
D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let O=S.uuid,z=D.uuid,G=l[O];G===void 0&&(G={},l[O]=G);let X=G[z];X===void 0&&(X=S.clone(),G[z]=X,D.addEventListener("dispose",I)),S=X}if(S.visible=D.visible,S.wireframe=D.wireframe,w===Xi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,
S.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,N.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let O=i.
properties.get(S);O.light=N}return S}function y(A,D,N,w,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Xi)&&(!A.frustumCulled||n.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,A.matrixWorld);let z=t.update(A),G=A.material;if(Array.isArray(G)){let X=z.groups;for(let q=0,Z=X.length;q<Z;q++){
let j=X[q],rt=G[j.materialIndex];if(rt&&rt.visible){let ot=T(A,rt,w,S);A.onBeforeShadow(i,A,D,N,z,ot,j),i.renderBufferDirect(N,null,z,ot,A,j),A.onAfterShadow(i,A,D,N,z,ot,j)}}}else if(G.visible){let X=T(A,G,w,S);A.onBeforeShadow(i,A,D,N,z,X,null),i.renderBufferDirect(N,null,z,X,A,null),A.onAfterShadow(i,A,D,N,z,X,null)}}let O=A.children;for(let z=0,G=O.length;z<G;z++)y(O[z],D,N,w,S)}function I(A){
A.target.removeEventListener("dispose",I);for(let N in l){let w=l[N],S=A.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}var P1={[dc]:pc,[mc]:_c,[gc]:xc,[er]:vc,[pc]:dc,[_c]:mc,[xc]:gc,[vc]:er};function I1(i,t){function e(){let B=!1,ut=new je,dt=null,It=new je(0,0,0,0);return{setMask:function(ct){dt!==ct&&!B&&(i.colorMask(ct,ct,ct,ct),dt=ct)},setLocked:function(ct){B=ct},setClear:function(ct,st,Bt,ne,Ue){
Ue===!0&&(ct*=ne,st*=ne,Bt*=ne),ut.set(ct,st,Bt,ne),It.equals(ut)===!1&&(i.clearColor(ct,st,Bt,ne),It.copy(ut))},reset:function(){B=!1,dt=null,It.set(-1,0,0,0)}}}function n(){let B=!1,ut=!1,dt=null,It=null,ct=null;return{setReversed:function(st){if(ut!==st){let Bt=t.get("EXT_clip_control");st?Bt.clipControlEXT(Bt.LOWER_LEFT_EXT,Bt.ZERO_TO_ONE_EXT):Bt.clipControlEXT(Bt.LOWER_LEFT_EXT,Bt.NEGATIVE_ONE_TO_ONE_EXT),
ut=st;let ne=ct;ct=null,this.setClear(ne)}},getReversed:function(){return ut},setTest:function(st){st?tt(i.DEPTH_TEST):Mt(i.DEPTH_TEST)},setMask:function(st){dt!==st&&!B&&(i.depthMask(st),dt=st)},setFunc:function(st){if(ut&&(st=P1[st]),It!==st){switch(st){case dc:i.depthFunc(i.NEVER);break;case pc:i.depthFunc(i.ALWAYS);break;case mc:i.depthFunc(i.LESS);break;case er:i.depthFunc(i.LEQUAL);break;case gc:
i.depthFunc(i.EQUAL);break;case vc:i.depthFunc(i.GEQUAL);break;case _c:i.depthFunc(i.GREATER);break;case xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}It=st}},setLocked:function(st){B=st},setClear:function(st){ct!==st&&(ut&&(st=1-st),i.clearDepth(st),ct=st)},reset:function(){B=!1,dt=null,It=null,ct=null,ut=!1}}}function s(){let B=!1,ut=null,dt=null,It=null,ct=null,st=null,Bt=null,
ne=null,Ue=null;return{setTest:function(Me){B||(Me?tt(i.STENCIL_TEST):Mt(i.STENCIL_TEST))},setMask:function(Me){ut!==Me&&!B&&(i.stencilMask(Me),ut=Me)},setFunc:function(Me,yn,Ne){(dt!==Me||It!==yn||ct!==Ne)&&(i.stencilFunc(Me,yn,Ne),dt=Me,It=yn,ct=Ne)},setOp:function(Me,yn,Ne){(st!==Me||Bt!==yn||ne!==Ne)&&(i.stencilOp(Me,yn,Ne),st=Me,Bt=yn,ne=Ne)},setLocked:function(Me){B=Me},setClear:function(Me){
Ue!==Me&&(i.clearStencil(Me),Ue=Me)},reset:function(){B=!1,ut=null,dt=null,It=null,ct=null,st=null,Bt=null,ne=null,Ue=null}}}let r=new e,o=new n,a=new s,c=new WeakMap,l=new WeakMap,h={},u={},f=new WeakMap,d=[],g=null,_=!1,m=null,p=null,b=null,T=null,y=null,I=null,A=null,D=new ae(0,0,0),N=0,w=!1,S=null,C=null,O=null,z=null,G=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,Z=0,j=i.getParameter(
i.VERSION);j.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(j)[1]),q=Z>=1):j.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),q=Z>=2);let rt=null,ot={},vt=i.getParameter(i.SCISSOR_BOX),xt=i.getParameter(i.VIEWPORT),pt=new je().fromArray(vt),ee=new je().fromArray(xt);function Zt(B,ut,dt,It){let ct=new Uint8Array(4),st=i.createTexture();i.bindTexture(B,st),i.texParameteri(
B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Bt=0;Bt<dt;Bt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ut,0,i.RGBA,1,1,It,0,i.RGBA,i.UNSIGNED_BYTE,ct):i.texImage2D(ut+Bt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ct);return st}let Q={};Q[i.TEXTURE_2D]=Zt(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=Zt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,
6),Q[i.TEXTURE_2D_ARRAY]=Zt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=Zt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),tt(i.DEPTH_TEST),o.setFunc(er),qt(!1),Ft(Ku),tt(i.CULL_FACE),xe(hs);function tt(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Mt(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function Ot(B,ut){return u[B]!==ut?(i.bindFramebuffer(B,ut),u[B]=ut,
B===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=ut),B===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=ut),!0):!1}function _t(B,ut){let dt=d,It=!1;if(B){dt=f.get(ut),dt===void 0&&(dt=[],f.set(ut,dt));let ct=B.textures;if(dt.length!==ct.length||dt[0]!==i.COLOR_ATTACHMENT0){for(let st=0,Bt=ct.length;st<Bt;st++)dt[st]=i.COLOR_ATTACHMENT0+st;dt.length=ct.length,It=!0}}else dt[0]!==i.BACK&&(dt[0]=i.BACK,It=!0);It&&i.
drawBuffers(dt)}function Qt(B){return g!==B?(i.useProgram(B),g=B,!0):!1}let Pe={[Rs]:i.FUNC_ADD,[jm]:i.FUNC_SUBTRACT,[Qm]:i.FUNC_REVERSE_SUBTRACT};Pe[tg]=i.MIN,Pe[eg]=i.MAX;let U={[ng]:i.ZERO,[ig]:i.ONE,[sg]:i.SRC_COLOR,[zl]:i.SRC_ALPHA,[hg]:i.SRC_ALPHA_SATURATE,[lg]:i.DST_COLOR,[og]:i.DST_ALPHA,[rg]:i.ONE_MINUS_SRC_COLOR,[Vl]:i.ONE_MINUS_SRC_ALPHA,[cg]:i.ONE_MINUS_DST_COLOR,[ag]:i.ONE_MINUS_DST_ALPHA,
[ug]:i.CONSTANT_COLOR,[fg]:i.ONE_MINUS_CONSTANT_COLOR,[dg]:i.CONSTANT_ALPHA,[pg]:i.ONE_MINUS_CONSTANT_ALPHA};function xe(B,ut,dt,It,ct,st,Bt,ne,Ue,Me){if(B===hs){_===!0&&(Mt(i.BLEND),_=!1);return}if(_===!1&&(tt(i.BLEND),_=!0),B!==Km){if(B!==m||Me!==w){if((p!==Rs||y!==Rs)&&(i.blendEquation(i.FUNC_ADD),p=Rs,y=Rs),Me)switch(B){case tr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);
break;case Qu:i.blendFunc(i.ONE,i.ONE);break;case tf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ef:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}else switch(B){case tr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Qu:i.blendFuncSeparate(
i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case tf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ef:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",B);break}b=null,T=null,I=null,A=null,D.set(0,0,0),N=0,m=B,w=Me}return}ct=ct||ut,
st=st||dt,Bt=Bt||It,(ut!==p||ct!==y)&&(i.blendEquationSeparate(Pe[ut],Pe[ct]),p=ut,y=ct),(dt!==b||It!==T||st!==I||Bt!==A)&&(i.blendFuncSeparate(U[dt],U[It],U[st],U[Bt]),b=dt,T=It,I=st,A=Bt),(ne.equals(D)===!1||Ue!==N)&&(i.blendColor(ne.r,ne.g,ne.b,Ue),D.copy(ne),N=Ue),m=B,w=!1}function Kt(B,ut){B.side===mi?Mt(i.CULL_FACE):tt(i.CULL_FACE);let dt=B.side===zn;ut&&(dt=!dt),qt(dt),B.blending===tr&&B.transparent===
!1?xe(hs):xe(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let It=B.stencilWrite;a.setTest(It),It&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,
B.stencilZFail,B.stencilZPass)),Pt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?tt(i.SAMPLE_ALPHA_TO_COVERAGE):Mt(i.SAMPLE_ALPHA_TO_COVERAGE)}function qt(B){S!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),S=B)}function Ft(B){B!==Zm?(tt(i.CULL_FACE),B!==C&&(B===Ku?i.cullFace(i.BACK):B===Jm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Mt(i.CULL_FACE),C=B}function Ie(B){
B!==O&&(q&&i.lineWidth(B),O=B)}function Pt(B,ut,dt){B?(tt(i.POLYGON_OFFSET_FILL),(z!==ut||G!==dt)&&(i.polygonOffset(ut,dt),z=ut,G=dt)):Mt(i.POLYGON_OFFSET_FILL)}function Xt(B){B?tt(i.SCISSOR_TEST):Mt(i.SCISSOR_TEST)}function He(B){B===void 0&&(B=i.TEXTURE0+X-1),rt!==B&&(i.activeTexture(B),rt=B)}function Ee(B,ut,dt){dt===void 0&&(rt===null?dt=i.TEXTURE0+X-1:dt=rt);let It=ot[dt];It===void 0&&(It={type:void 0,
texture:void 0},ot[dt]=It),(It.type!==B||It.texture!==ut)&&(rt!==dt&&(i.activeTexture(dt),rt=dt),i.bindTexture(B,ut||Q[B]),It.type=B,It.texture=ut)}function P(){let B=ot[rt];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function F(){try{i.compressedTexImage3D(
...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function J(){try{i.texSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function nt(){try{i.texSubImage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function et(){try{i.compressedTexSubImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Nt(){try{i.compressedTexSubImage3D(...arguments)}catch(B){
console.error("THREE.WebGLState:",B)}}function ht(){try{i.texStorage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function Lt(){try{i.texStorage3D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function At(){try{i.texImage2D(...arguments)}catch(B){console.error("THREE.WebGLState:",B)}}function at(){try{i.texImage3D(...arguments)}catch(B){console.error("THREE.WebGLSt\
ate:",B)}}function gt(B){pt.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),pt.copy(B))}function zt(B){ee.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),ee.copy(B))}function kt(B,ut){let dt=l.get(ut);dt===void 0&&(dt=new WeakMap,l.set(ut,dt));let It=dt.get(B);It===void 0&&(It=i.getUniformBlockIndex(ut,B.name),dt.set(B,It))}function yt(B,ut){let It=l.get(ut).get(B);c.get(ut)!==It&&(i.uniformBlockBinding(
ut,It,B.__bindingPointIndex),c.set(ut,It))}function te(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(
0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),
i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},rt=null,ot={},u={},f=new WeakMap,d=[],g=null,_=!1,m=null,p=null,b=null,T=null,y=null,I=null,A=null,D=new ae(0,0,0),N=0,w=!1,S=null,C=null,O=null,z=null,G=null,pt.set(0,0,i.canvas.width,i.canvas.height),ee.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}
return{buffers:{color:r,depth:o,stencil:a},enable:tt,disable:Mt,bindFramebuffer:Ot,drawBuffers:_t,useProgram:Qt,setBlending:xe,setMaterial:Kt,setFlipSided:qt,setCullFace:Ft,setLineWidth:Ie,setPolygonOffset:Pt,setScissorTest:Xt,activeTexture:He,bindTexture:Ee,unbindTexture:P,compressedTexImage2D:x,compressedTexImage3D:F,texImage2D:At,texImage3D:at,updateUBOMapping:kt,uniformBlockBinding:yt,texStorage2D:ht,
texStorage3D:Lt,texSubImage2D:J,texSubImage3D:nt,compressedTexSubImage2D:et,compressedTexSubImage3D:Nt,scissor:gt,viewport:zt,reset:te}}function L1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new me,h=new WeakMap,u,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<
"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,x){return d?new OffscreenCanvas(P,x):na("canvas")}function _(P,x,F){let J=1,nt=Ee(P);if((nt.width>F||nt.height>F)&&(J=F/Math.max(nt.width,nt.height)),J<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||
typeof VideoFrame<"u"&&P instanceof VideoFrame){let et=Math.floor(J*nt.width),Nt=Math.floor(J*nt.height);u===void 0&&(u=g(et,Nt));let ht=x?g(et,Nt):u;return ht.width=et,ht.height=Nt,ht.getContext("2d").drawImage(P,0,0,et,Nt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+et+"x"+Nt+")."),ht}else return"data"in P&&console.warn("THREE.WebGLRenderer\
: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){i.generateMipmap(P)}function b(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(P,x,F,J,nt=!1){if(P!==null){if(i[P]!==void 0)return i[P];
console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=x;if(x===i.RED&&(F===i.FLOAT&&(et=i.R32F),F===i.HALF_FLOAT&&(et=i.R16F),F===i.UNSIGNED_BYTE&&(et=i.R8)),x===i.RED_INTEGER&&(F===i.UNSIGNED_BYTE&&(et=i.R8UI),F===i.UNSIGNED_SHORT&&(et=i.R16UI),F===i.UNSIGNED_INT&&(et=i.R32UI),F===i.BYTE&&(et=i.R8I),F===i.SHORT&&(et=i.R16I),F===i.INT&&(et=i.R32I)),x===
i.RG&&(F===i.FLOAT&&(et=i.RG32F),F===i.HALF_FLOAT&&(et=i.RG16F),F===i.UNSIGNED_BYTE&&(et=i.RG8)),x===i.RG_INTEGER&&(F===i.UNSIGNED_BYTE&&(et=i.RG8UI),F===i.UNSIGNED_SHORT&&(et=i.RG16UI),F===i.UNSIGNED_INT&&(et=i.RG32UI),F===i.BYTE&&(et=i.RG8I),F===i.SHORT&&(et=i.RG16I),F===i.INT&&(et=i.RG32I)),x===i.RGB_INTEGER&&(F===i.UNSIGNED_BYTE&&(et=i.RGB8UI),F===i.UNSIGNED_SHORT&&(et=i.RGB16UI),F===i.UNSIGNED_INT&&
(et=i.RGB32UI),F===i.BYTE&&(et=i.RGB8I),F===i.SHORT&&(et=i.RGB16I),F===i.INT&&(et=i.RGB32I)),x===i.RGBA_INTEGER&&(F===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),F===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),F===i.UNSIGNED_INT&&(et=i.RGBA32UI),F===i.BYTE&&(et=i.RGBA8I),F===i.SHORT&&(et=i.RGBA16I),F===i.INT&&(et=i.RGBA32I)),x===i.RGB&&(F===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),F===i.UNSIGNED_INT_10F_11F_11F_REV&&
(et=i.R11F_G11F_B10F)),x===i.RGBA){let Nt=nt?ta:ye.getTransfer(J);F===i.FLOAT&&(et=i.RGBA32F),F===i.HALF_FLOAT&&(et=i.RGBA16F),F===i.UNSIGNED_BYTE&&(et=Nt===De?i.SRGB8_ALPHA8:i.RGBA8),F===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),F===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}
function y(P,x){let F;return P?x===null||x===Ds||x===yo?F=i.DEPTH24_STENCIL8:x===Di?F=i.DEPTH32F_STENCIL8:x===_o&&(F=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ds||x===yo?F=i.DEPTH_COMPONENT24:x===Di?F=i.DEPTH_COMPONENT32F:x===_o&&(F=i.DEPTH_COMPONENT16),F}function I(P,x){return m(P)===!0||P.isFramebufferTexture&&
P.minFilter!==qn&&P.minFilter!==Pi?Math.log2(Math.max(x.width,x.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?x.mipmaps.length:1}function A(P){let x=P.target;x.removeEventListener("dispose",A),N(x),x.isVideoTexture&&h.delete(x)}function D(P){let x=P.target;x.removeEventListener("dispose",D),S(x)}function N(P){let x=n.get(P);if(x.__webglInit===
void 0)return;let F=P.source,J=f.get(F);if(J){let nt=J[x.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&w(P),Object.keys(J).length===0&&f.delete(F)}n.remove(P)}function w(P){let x=n.get(P);i.deleteTexture(x.__webglTexture);let F=P.source,J=f.get(F);delete J[x.__cacheKey],o.memory.textures--}function S(P){let x=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)
for(let J=0;J<6;J++){if(Array.isArray(x.__webglFramebuffer[J]))for(let nt=0;nt<x.__webglFramebuffer[J].length;nt++)i.deleteFramebuffer(x.__webglFramebuffer[J][nt]);else i.deleteFramebuffer(x.__webglFramebuffer[J]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[J])}else{if(Array.isArray(x.__webglFramebuffer))for(let J=0;J<x.__webglFramebuffer.length;J++)i.deleteFramebuffer(x.__webglFramebuffer[J]);else
i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let J=0;J<x.__webglColorRenderbuffer.length;J++)x.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[J]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(
x.__webglDepthRenderbuffer)}let F=P.textures;for(let J=0,nt=F.length;J<nt;J++){let et=n.get(F[J]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(F[J])}n.remove(P)}let C=0;function O(){C=0}function z(){let P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function G(P){
let x=[];return x.push(P.wrapS),x.push(P.wrapT),x.push(P.wrapR||0),x.push(P.magFilter),x.push(P.minFilter),x.push(P.anisotropy),x.push(P.internalFormat),x.push(P.format),x.push(P.type),x.push(P.generateMipmaps),x.push(P.premultiplyAlpha),x.push(P.flipY),x.push(P.unpackAlignment),x.push(P.colorSpace),x.join()}function X(P,x){let F=n.get(P);if(P.isVideoTexture&&Xt(P),P.isRenderTargetTexture===!1&&P.
isExternalTexture!==!0&&P.version>0&&F.__version!==P.version){let J=P.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(F,P,x);return}}else P.isExternalTexture&&(F.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(
i.TEXTURE_2D,F.__webglTexture,i.TEXTURE0+x)}function q(P,x){let F=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&F.__version!==P.version){Q(F,P,x);return}e.bindTexture(i.TEXTURE_2D_ARRAY,F.__webglTexture,i.TEXTURE0+x)}function Z(P,x){let F=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&F.__version!==P.version){Q(F,P,x);return}e.bindTexture(i.TEXTURE_3D,F.__webglTexture,i.TEXTURE0+x)}
function j(P,x){let F=n.get(P);if(P.version>0&&F.__version!==P.version){tt(F,P,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+x)}let rt={[Hl]:i.REPEAT,[Cs]:i.CLAMP_TO_EDGE,[Gl]:i.MIRRORED_REPEAT},ot={[qn]:i.NEAREST,[wg]:i.NEAREST_MIPMAP_NEAREST,[ba]:i.NEAREST_MIPMAP_LINEAR,[Pi]:i.LINEAR,[bc]:i.LINEAR_MIPMAP_NEAREST,[Ls]:i.LINEAR_MIPMAP_LINEAR},vt={[Cg]:i.NEVER,[Ug]:i.ALWAYS,
[Rg]:i.LESS,[uf]:i.LEQUAL,[Pg]:i.EQUAL,[Dg]:i.GEQUAL,[Ig]:i.GREATER,[Lg]:i.NOTEQUAL};function xt(P,x){if(x.type===Di&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===Pi||x.magFilter===bc||x.magFilter===ba||x.magFilter===Ls||x.minFilter===Pi||x.minFilter===bc||x.minFilter===ba||x.minFilter===Ls)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. \
OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,rt[x.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,rt[x.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,rt[x.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ot[x.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ot[x.minFilter]),x.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,
i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,vt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===qn||x.minFilter!==ba&&x.minFilter!==Ls||x.type===Di&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let F=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.
min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function pt(P,x){let F=!1;P.__webglInit===void 0&&(P.__webglInit=!0,x.addEventListener("dispose",A));let J=x.source,nt=f.get(J);nt===void 0&&(nt={},f.set(J,nt));let et=G(x);if(et!==P.__cacheKey){nt[et]===void 0&&(nt[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,F=!0),nt[et].usedTimes++;let Nt=nt[P.
__cacheKey];Nt!==void 0&&(nt[P.__cacheKey].usedTimes--,Nt.usedTimes===0&&w(x)),P.__cacheKey=et,P.__webglTexture=nt[et].texture}return F}function ee(P,x,F){return Math.floor(Math.floor(P/F)/x)}function Zt(P,x,F,J){let et=P.updateRanges;if(et.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,F,J,x.data);else{et.sort((at,gt)=>at.start-gt.start);let Nt=0;for(let at=1;at<et.length;at++){let gt=et[Nt],
zt=et[at],kt=gt.start+gt.count,yt=ee(zt.start,x.width,4),te=ee(gt.start,x.width,4);zt.start<=kt+1&&yt===te&&ee(zt.start+zt.count-1,x.width,4)===yt?gt.count=Math.max(gt.count,zt.start+zt.count-gt.start):(++Nt,et[Nt]=zt)}et.length=Nt+1;let ht=i.getParameter(i.UNPACK_ROW_LENGTH),Lt=i.getParameter(i.UNPACK_SKIP_PIXELS),At=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let at=0,
gt=et.length;at<gt;at++){let zt=et[at],kt=Math.floor(zt.start/4),yt=Math.ceil(zt.count/4),te=kt%x.width,B=Math.floor(kt/x.width),ut=yt,dt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,te),i.pixelStorei(i.UNPACK_SKIP_ROWS,B),e.texSubImage2D(i.TEXTURE_2D,0,te,B,ut,dt,F,J,x.data)}P.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ht),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Lt),i.pixelStorei(i.UNPACK_SKIP_ROWS,
At)}}function Q(P,x,F){let J=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(J=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(J=i.TEXTURE_3D);let nt=pt(P,x),et=x.source;e.bindTexture(J,P.__webglTexture,i.TEXTURE0+F);let Nt=n.get(et);if(et.version!==Nt.__version||nt===!0){e.activeTexture(i.TEXTURE0+F);let ht=ye.getPrimaries(ye.workingColorSpace),Lt=x.colorSpace===fs?null:ye.getPrimaries(
x.colorSpace),At=x.colorSpace===fs||ht===Lt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,At);let at=_(x.image,!1,s.maxTextureSize);at=He(x,at);let gt=r.convert(x.format,x.colorSpace),zt=r.convert(x.type),
kt=T(x.internalFormat,gt,zt,x.colorSpace,x.isVideoTexture);xt(J,x);let yt,te=x.mipmaps,B=x.isVideoTexture!==!0,ut=Nt.__version===void 0||nt===!0,dt=et.dataReady,It=I(x,at);if(x.isDepthTexture)kt=y(x.format===Mo,x.type),ut&&(B?e.texStorage2D(i.TEXTURE_2D,1,kt,at.width,at.height):e.texImage2D(i.TEXTURE_2D,0,kt,at.width,at.height,0,gt,zt,null));else if(x.isDataTexture)if(te.length>0){B&&ut&&e.texStorage2D(
i.TEXTURE_2D,It,kt,te[0].width,te[0].height);for(let ct=0,st=te.length;ct<st;ct++)yt=te[ct],B?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,yt.width,yt.height,gt,zt,yt.data):e.texImage2D(i.TEXTURE_2D,ct,kt,yt.width,yt.height,0,gt,zt,yt.data);x.generateMipmaps=!1}else B?(ut&&e.texStorage2D(i.TEXTURE_2D,It,kt,at.width,at.height),dt&&Zt(x,at,gt,zt)):e.texImage2D(i.TEXTURE_2D,0,kt,at.width,at.height,0,gt,zt,
at.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){B&&ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,It,kt,te[0].width,te[0].height,at.depth);for(let ct=0,st=te.length;ct<st;ct++)if(yt=te[ct],x.format!==gi)if(gt!==null)if(B){if(dt)if(x.layerUpdates.size>0){let Bt=vf(yt.width,yt.height,x.format,x.type);for(let ne of x.layerUpdates){let Ue=yt.data.subarray(ne*Bt/yt.data.BYTES_PER_ELEMENT,(ne+
1)*Bt/yt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,ne,yt.width,yt.height,1,gt,Ue)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,yt.width,yt.height,at.depth,gt,yt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,kt,yt.width,yt.height,at.depth,0,yt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported\
 compressed texture format in .uploadTexture()");else B?dt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,yt.width,yt.height,at.depth,gt,zt,yt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,kt,yt.width,yt.height,at.depth,0,gt,zt,yt.data)}else{B&&ut&&e.texStorage2D(i.TEXTURE_2D,It,kt,te[0].width,te[0].height);for(let ct=0,st=te.length;ct<st;ct++)yt=te[ct],x.format!==gi?gt!==null?B?dt&&e.compressedTexSubImage2D(
i.TEXTURE_2D,ct,0,0,yt.width,yt.height,gt,yt.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,kt,yt.width,yt.height,0,yt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):B?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,yt.width,yt.height,gt,zt,yt.data):e.texImage2D(i.TEXTURE_2D,ct,kt,yt.width,yt.height,0,gt,zt,yt.data)}else if(x.isDataArrayTexture)
if(B){if(ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,It,kt,at.width,at.height,at.depth),dt)if(x.layerUpdates.size>0){let ct=vf(at.width,at.height,x.format,x.type);for(let st of x.layerUpdates){let Bt=at.data.subarray(st*ct/at.data.BYTES_PER_ELEMENT,(st+1)*ct/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,st,at.width,at.height,1,gt,zt,Bt)}x.clearLayerUpdates()}else e.texSubImage3D(i.
TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,gt,zt,at.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,kt,at.width,at.height,at.depth,0,gt,zt,at.data);else if(x.isData3DTexture)B?(ut&&e.texStorage3D(i.TEXTURE_3D,It,kt,at.width,at.height,at.depth),dt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,gt,zt,at.data)):e.texImage3D(i.TEXTURE_3D,0,kt,at.width,at.height,at.depth,0,gt,
zt,at.data);else if(x.isFramebufferTexture){if(ut)if(B)e.texStorage2D(i.TEXTURE_2D,It,kt,at.width,at.height);else{let ct=at.width,st=at.height;for(let Bt=0;Bt<It;Bt++)e.texImage2D(i.TEXTURE_2D,Bt,kt,ct,st,0,gt,zt,null),ct>>=1,st>>=1}}else if(te.length>0){if(B&&ut){let ct=Ee(te[0]);e.texStorage2D(i.TEXTURE_2D,It,kt,ct.width,ct.height)}for(let ct=0,st=te.length;ct<st;ct++)yt=te[ct],B?dt&&e.texSubImage2D(
i.TEXTURE_2D,ct,0,0,gt,zt,yt):e.texImage2D(i.TEXTURE_2D,ct,kt,gt,zt,yt);x.generateMipmaps=!1}else if(B){if(ut){let ct=Ee(at);e.texStorage2D(i.TEXTURE_2D,It,kt,ct.width,ct.height)}dt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,zt,at)}else e.texImage2D(i.TEXTURE_2D,0,kt,gt,zt,at);m(x)&&p(J),Nt.__version=et.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function tt(P,x,F){if(x.image.length!==6)return;
let J=pt(P,x),nt=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+F);let et=n.get(nt);if(nt.version!==et.__version||J===!0){e.activeTexture(i.TEXTURE0+F);let Nt=ye.getPrimaries(ye.workingColorSpace),ht=x.colorSpace===fs?null:ye.getPrimaries(x.colorSpace),Lt=x.colorSpace===fs||Nt===ht?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,
x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Lt);let At=x.isCompressedTexture||x.image[0].isCompressedTexture,at=x.image[0]&&x.image[0].isDataTexture,gt=[];for(let st=0;st<6;st++)!At&&!at?gt[st]=_(x.image[st],!0,s.maxCubemapSize):gt[st]=at?x.image[st].image:x.image[st],gt[st]=He(x,gt[st]);let zt=gt[0],kt=r.convert(x.format,
x.colorSpace),yt=r.convert(x.type),te=T(x.internalFormat,kt,yt,x.colorSpace),B=x.isVideoTexture!==!0,ut=et.__version===void 0||J===!0,dt=nt.dataReady,It=I(x,zt);xt(i.TEXTURE_CUBE_MAP,x);let ct;if(At){B&&ut&&e.texStorage2D(i.TEXTURE_CUBE_MAP,It,te,zt.width,zt.height);for(let st=0;st<6;st++){ct=gt[st].mipmaps;for(let Bt=0;Bt<ct.length;Bt++){let ne=ct[Bt];x.format!==gi?kt!==null?B?dt&&e.compressedTexSubImage2D(
i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt,0,0,ne.width,ne.height,kt,ne.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt,te,ne.width,ne.height,0,ne.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt,0,0,ne.width,ne.height,kt,yt,ne.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+
st,Bt,te,ne.width,ne.height,0,kt,yt,ne.data)}}}else{if(ct=x.mipmaps,B&&ut){ct.length>0&&It++;let st=Ee(gt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,It,te,st.width,st.height)}for(let st=0;st<6;st++)if(at){B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,gt[st].width,gt[st].height,kt,yt,gt[st].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,te,gt[st].width,gt[st].height,0,kt,yt,gt[st].
data);for(let Bt=0;Bt<ct.length;Bt++){let Ue=ct[Bt].image[st].image;B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt+1,0,0,Ue.width,Ue.height,kt,yt,Ue.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt+1,te,Ue.width,Ue.height,0,kt,yt,Ue.data)}}else{B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,kt,yt,gt[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,te,kt,yt,gt[st]);
for(let Bt=0;Bt<ct.length;Bt++){let ne=ct[Bt];B?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt+1,0,0,kt,yt,ne.image[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Bt+1,te,kt,yt,ne.image[st])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),et.__version=nt.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function Mt(P,x,F,J,nt,et){let Nt=r.convert(F.format,F.colorSpace),ht=r.convert(F.type),Lt=T(F.
internalFormat,Nt,ht,F.colorSpace),At=n.get(x),at=n.get(F);if(at.__renderTarget=x,!At.__hasExternalTextures){let gt=Math.max(1,x.width>>et),zt=Math.max(1,x.height>>et);nt===i.TEXTURE_3D||nt===i.TEXTURE_2D_ARRAY?e.texImage3D(nt,et,Lt,gt,zt,x.depth,0,Nt,ht,null):e.texImage2D(nt,et,Lt,gt,zt,0,Nt,ht,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),Pt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,J,nt,
at.__webglTexture,0,Ie(x)):(nt===i.TEXTURE_2D||nt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,J,nt,at.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ot(P,x,F){if(i.bindRenderbuffer(i.RENDERBUFFER,P),x.depthBuffer){let J=x.depthTexture,nt=J&&J.isDepthTexture?J.type:null,et=y(x.stencilBuffer,nt),Nt=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:
i.DEPTH_ATTACHMENT,ht=Ie(x);Pt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht,et,x.width,x.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht,et,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,et,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Nt,i.RENDERBUFFER,P)}else{let J=x.textures;for(let nt=0;nt<J.length;nt++){let et=J[nt],Nt=r.convert(et.format,et.colorSpace),
ht=r.convert(et.type),Lt=T(et.internalFormat,Nt,ht,et.colorSpace),At=Ie(x);F&&Pt(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,At,Lt,x.width,x.height):Pt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,At,Lt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Lt,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function _t(P,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error(
"Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let J=n.get(x.depthTexture);J.__renderTarget=x,(!J.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.
width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),X(x.depthTexture,0);let nt=J.__webglTexture,et=Ie(x);if(x.depthTexture.format===eo)Pt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0);else if(x.depthTexture.format===Mo)Pt(x)?a.framebufferTexture2DMultisampleEXT(
i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0);else throw new Error("Unknown depthTexture format")}function Qt(P){let x=n.get(P),F=P.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==P.depthTexture){let J=P.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),J){let nt=()=>{delete x.
__boundDepthTexture,delete x.__depthDisposeCallback,J.removeEventListener("dispose",nt)};J.addEventListener("dispose",nt),x.__depthDisposeCallback=nt}x.__boundDepthTexture=J}if(P.depthTexture&&!x.__autoAllocateDepthBuffer){if(F)throw new Error("target.depthTexture not supported in Cube render targets");let J=P.texture.mipmaps;J&&J.length>0?_t(x.__webglFramebuffer[0],P):_t(x.__webglFramebuffer,P)}else if(F){
x.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[J]),x.__webglDepthbuffer[J]===void 0)x.__webglDepthbuffer[J]=i.createRenderbuffer(),Ot(x.__webglDepthbuffer[J],P,!1);else{let nt=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=x.__webglDepthbuffer[J];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.
RENDERBUFFER,et)}}else{let J=P.texture.mipmaps;if(J&&J.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Ot(x.__webglDepthbuffer,P,!1);else{let nt=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,
et),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,et)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Pe(P,x,F){let J=n.get(P);x!==void 0&&Mt(J.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),F!==void 0&&Qt(P)}function U(P){let x=P.texture,F=n.get(P),J=n.get(x);P.addEventListener("dispose",D);let nt=P.textures,et=P.isWebGLCubeRenderTarget===!0,Nt=nt.length>1;if(Nt||(J.
__webglTexture===void 0&&(J.__webglTexture=i.createTexture()),J.__version=x.version,o.memory.textures++),et){F.__webglFramebuffer=[];for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0){F.__webglFramebuffer[ht]=[];for(let Lt=0;Lt<x.mipmaps.length;Lt++)F.__webglFramebuffer[ht][Lt]=i.createFramebuffer()}else F.__webglFramebuffer[ht]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){F.
__webglFramebuffer=[];for(let ht=0;ht<x.mipmaps.length;ht++)F.__webglFramebuffer[ht]=i.createFramebuffer()}else F.__webglFramebuffer=i.createFramebuffer();if(Nt)for(let ht=0,Lt=nt.length;ht<Lt;ht++){let At=n.get(nt[ht]);At.__webglTexture===void 0&&(At.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Pt(P)===!1){F.__webglMultisampledFramebuffer=i.createFramebuffer(),F.__webglColorRenderbuffer=
[],e.bindFramebuffer(i.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let ht=0;ht<nt.length;ht++){let Lt=nt[ht];F.__webglColorRenderbuffer[ht]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,F.__webglColorRenderbuffer[ht]);let At=r.convert(Lt.format,Lt.colorSpace),at=r.convert(Lt.type),gt=T(Lt.internalFormat,At,at,Lt.colorSpace,P.isXRRenderTarget===!0),zt=Ie(P);i.renderbufferStorageMultisample(
i.RENDERBUFFER,zt,gt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ht,i.RENDERBUFFER,F.__webglColorRenderbuffer[ht])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(F.__webglDepthRenderbuffer=i.createRenderbuffer(),Ot(F.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture),xt(i.TEXTURE_CUBE_MAP,
x);for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0)for(let Lt=0;Lt<x.mipmaps.length;Lt++)Mt(F.__webglFramebuffer[ht][Lt],P,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,Lt);else Mt(F.__webglFramebuffer[ht],P,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,0);m(x)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Nt){for(let ht=0,Lt=nt.length;ht<Lt;ht++){let At=nt[ht],at=n.get(
At),gt=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(gt=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(gt,at.__webglTexture),xt(gt,At),Mt(F.__webglFramebuffer,P,At,i.COLOR_ATTACHMENT0+ht,gt,0),m(At)&&p(gt)}e.unbindTexture()}else{let ht=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ht=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),
e.bindTexture(ht,J.__webglTexture),xt(ht,x),x.mipmaps&&x.mipmaps.length>0)for(let Lt=0;Lt<x.mipmaps.length;Lt++)Mt(F.__webglFramebuffer[Lt],P,x,i.COLOR_ATTACHMENT0,ht,Lt);else Mt(F.__webglFramebuffer,P,x,i.COLOR_ATTACHMENT0,ht,0);m(x)&&p(ht),e.unbindTexture()}P.depthBuffer&&Qt(P)}function xe(P){let x=P.textures;for(let F=0,J=x.length;F<J;F++){let nt=x[F];if(m(nt)){let et=b(P),Nt=n.get(nt).__webglTexture;
e.bindTexture(et,Nt),p(et),e.unbindTexture()}}}let Kt=[],qt=[];function Ft(P){if(P.samples>0){if(Pt(P)===!1){let x=P.textures,F=P.width,J=P.height,nt=i.COLOR_BUFFER_BIT,et=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Nt=n.get(P),ht=x.length>1;if(ht)for(let At=0;At<x.length;At++)e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,
i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Nt.__webglMultisampledFramebuffer);let Lt=P.texture.mipmaps;Lt&&Lt.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Nt.
__webglFramebuffer);for(let At=0;At<x.length;At++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(nt|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(nt|=i.STENCIL_BUFFER_BIT)),ht){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Nt.__webglColorRenderbuffer[At]);let at=n.get(x[At]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,
i.TEXTURE_2D,at,0)}i.blitFramebuffer(0,0,F,J,0,0,F,J,nt,i.NEAREST),c===!0&&(Kt.length=0,qt.length=0,Kt.push(i.COLOR_ATTACHMENT0+At),P.depthBuffer&&P.resolveDepthBuffer===!1&&(Kt.push(et),qt.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,qt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Kt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ht)for(let At=0;At<
x.length;At++){e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,Nt.__webglColorRenderbuffer[At]);let at=n.get(x[At]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,at,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,
Nt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&c){let x=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Ie(P){return Math.min(s.maxSamples,P.samples)}function Pt(P){let x=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Xt(P){
let x=o.render.frame;h.get(P)!==x&&(h.set(P,x),P.update())}function He(P,x){let F=P.colorSpace,J=P.format,nt=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||F!==nr&&F!==fs&&(ye.getTransfer(F)===De?(J!==gi||nt!==Li)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color s\
pace:",F)),x}function Ee(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(l.width=P.naturalWidth||P.width,l.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(l.width=P.displayWidth,l.height=P.displayHeight):(l.width=P.width,l.height=P.height),l}this.allocateTextureUnit=z,this.resetTextureUnits=O,this.setTexture2D=X,this.setTexture2DArray=q,this.
setTexture3D=Z,this.setTextureCube=j,this.rebindTextures=Pe,this.setupRenderTarget=U,this.updateRenderTargetMipmap=xe,this.updateMultisampleRenderTarget=Ft,this.setupDepthRenderbuffer=Qt,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Pt}function D1(i,t){function e(n,s=fs){let r,o=ye.getTransfer(s);if(n===Li)return i.UNSIGNED_BYTE;if(n===wc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ec)return i.
UNSIGNED_SHORT_5_5_5_1;if(n===of)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===af)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===sf)return i.BYTE;if(n===rf)return i.SHORT;if(n===_o)return i.UNSIGNED_SHORT;if(n===Sc)return i.INT;if(n===Ds)return i.UNSIGNED_INT;if(n===Di)return i.FLOAT;if(n===xo)return i.HALF_FLOAT;if(n===lf)return i.ALPHA;if(n===cf)return i.RGB;if(n===gi)return i.RGBA;if(n===eo)return i.DEPTH_COMPONENT;
if(n===Mo)return i.DEPTH_STENCIL;if(n===Tc)return i.RED;if(n===Ac)return i.RED_INTEGER;if(n===hf)return i.RG;if(n===Cc)return i.RG_INTEGER;if(n===Rc)return i.RGBA_INTEGER;if(n===Sa||n===wa||n===Ea||n===Ta)if(o===De)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Sa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;
if(n===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Sa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ea)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ta)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Pc||n===Ic||n===Lc||n===Dc)if(r=t.get("WEBGL_compr\
essed_texture_pvrtc"),r!==null){if(n===Pc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ic)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Lc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Uc||n===Fc||n===Nc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Uc||n===Fc)return o===De?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;
if(n===Nc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Oc||n===Bc||n===kc||n===zc||n===Vc||n===Hc||n===Gc||n===Wc||n===Xc||n===qc||n===Yc||n===$c||n===Zc||n===Jc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Oc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Bc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:
r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===kc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===zc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Vc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Hc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;
if(n===Gc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Wc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Xc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===qc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Yc)return o===
De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===$c)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Zc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Jc)return o===De?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Kc||n===
jc||n===Qc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Kc)return o===De?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===jc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Qc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===th||n===eh||n===nh||n===ih)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===th)return r.COMPRESSED_RED_RGTC1_EXT;
if(n===eh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===nh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ih)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===yo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var U1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,F1=`
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

}`,Pf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new fa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ii({vertexShader:U1,fragmentShader:F1,uniforms:{
depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new wn(new sr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},If=class extends as{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,f=null,d=null,g=null,_=typeof XRWebGLBinding<"u",m=new Pf,p={},b=e.getContextAttributes(),
T=null,y=null,I=[],A=[],D=new me,N=null,w=new Rn;w.viewport=new je;let S=new Rn;S.viewport=new je;let C=[w,S],O=new uc,z=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let tt=I[Q];return tt===void 0&&(tt=new oo,I[Q]=tt),tt.getTargetRaySpace()},this.getControllerGrip=function(Q){let tt=I[Q];return tt===void 0&&(tt=new oo,I[Q]=tt),tt.getGripSpace()},
this.getHand=function(Q){let tt=I[Q];return tt===void 0&&(tt=new oo,I[Q]=tt),tt.getHandSpace()};function X(Q){let tt=A.indexOf(Q.inputSource);if(tt===-1)return;let Mt=I[tt];Mt!==void 0&&(Mt.update(Q.inputSource,Q.frame,l||o),Mt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function q(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),
s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",Z);for(let Q=0;Q<I.length;Q++){let tt=A[Q];tt!==null&&(A[Q]=null,I[Q].disconnect(tt))}z=null,G=null,m.reset();for(let Q in p)delete p[Q];t.setRenderTarget(T),d=null,f=null,u=null,s=null,y=null,Zt.stop(),n.isPresenting=
!1,t.setPixelRatio(N),t.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.
getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Q){l=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener(
"selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",q),s.addEventListener("inputsourceschange",Z),b.xrCompatible!==!0&&await e.makeXRCompatible(),N=t.getPixelRatio(),t.getSize(D),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let Mt=null,Ot=null,_t=null;b.depth&&(_t=
b.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Mt=b.stencil?Mo:eo,Ot=b.stencil?yo:Ds);let Qt={colorFormat:e.RGBA8,depthFormat:_t,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Qt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),y=new Hi(f.textureWidth,f.textureHeight,{format:gi,type:Li,depthTexture:new ua(f.textureWidth,f.textureHeight,
Ot,void 0,void 0,void 0,void 0,void 0,void 0,Mt),stencilBuffer:b.stencil,colorSpace:t.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let Mt={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,Mt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),
t.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new Hi(d.framebufferWidth,d.framebufferHeight,{format:gi,type:Li,colorSpace:t.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),Zt.setContext(s),Zt.start(),n.isPresenting=!0,n.dispatchEvent(
{type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Z(Q){for(let tt=0;tt<Q.removed.length;tt++){let Mt=Q.removed[tt],Ot=A.indexOf(Mt);Ot>=0&&(A[Ot]=null,I[Ot].disconnect(Mt))}for(let tt=0;tt<Q.added.length;tt++){let Mt=Q.added[tt],Ot=A.indexOf(Mt);if(Ot===-1){for(let Qt=0;Qt<
I.length;Qt++)if(Qt>=A.length){A.push(Mt),Ot=Qt;break}else if(A[Qt]===null){A[Qt]=Mt,Ot=Qt;break}if(Ot===-1)break}let _t=I[Ot];_t&&_t.connect(Mt)}}let j=new W,rt=new W;function ot(Q,tt,Mt){j.setFromMatrixPosition(tt.matrixWorld),rt.setFromMatrixPosition(Mt.matrixWorld);let Ot=j.distanceTo(rt),_t=tt.projectionMatrix.elements,Qt=Mt.projectionMatrix.elements,Pe=_t[14]/(_t[10]-1),U=_t[14]/(_t[10]+1),xe=(_t[9]+
1)/_t[5],Kt=(_t[9]-1)/_t[5],qt=(_t[8]-1)/_t[0],Ft=(Qt[8]+1)/Qt[0],Ie=Pe*qt,Pt=Pe*Ft,Xt=Ot/(-qt+Ft),He=Xt*-qt;if(tt.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(He),Q.translateZ(Xt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),_t[10]===-1)Q.projectionMatrix.copy(tt.projectionMatrix),Q.projectionMatrixInverse.copy(tt.
projectionMatrixInverse);else{let Ee=Pe+Xt,P=U+Xt,x=Ie-He,F=Pt+(Ot-He),J=xe*U/P*Ee,nt=Kt*U/P*Ee;Q.projectionMatrix.makePerspective(x,F,J,nt,Ee,P),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function vt(Q,tt){tt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(tt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){
if(s===null)return;let tt=Q.near,Mt=Q.far;m.texture!==null&&(m.depthNear>0&&(tt=m.depthNear),m.depthFar>0&&(Mt=m.depthFar)),O.near=S.near=w.near=tt,O.far=S.far=w.far=Mt,(z!==O.near||G!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),z=O.near,G=O.far),O.layers.mask=Q.layers.mask|6,w.layers.mask=O.layers.mask&3,S.layers.mask=O.layers.mask&5;let Ot=Q.parent,_t=O.cameras;vt(O,Ot);for(let Qt=0;Qt<
_t.length;Qt++)vt(_t[Qt],Ot);_t.length===2?ot(O,w,S):O.projectionMatrix.copy(w.projectionMatrix),xt(Q,O,Ot)};function xt(Q,tt,Mt){Mt===null?Q.matrix.copy(tt.matrixWorld):(Q.matrix.copy(Mt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(tt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(tt.projectionMatrix),Q.projectionMatrixInverse.
copy(tt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Xl*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(f===null&&d===null))return c},this.setFoveation=function(Q){c=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},
this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(Q){return p[Q]};let pt=null;function ee(Q,tt){if(h=tt.getViewerPose(l||o),g=tt,h!==null){let Mt=h.views;d!==null&&(t.setRenderTargetFramebuffer(y,d.framebuffer),t.setRenderTarget(y));let Ot=!1;Mt.length!==O.cameras.length&&(O.cameras.length=0,Ot=!0);for(let U=0;U<Mt.length;U++){let xe=Mt[U],Kt=null;if(d!==null)
Kt=d.getViewport(xe);else{let Ft=u.getViewSubImage(f,xe);Kt=Ft.viewport,U===0&&(t.setRenderTargetTextures(y,Ft.colorTexture,Ft.depthStencilTexture),t.setRenderTarget(y))}let qt=C[U];qt===void 0&&(qt=new Rn,qt.layers.enable(U),qt.viewport=new je,C[U]=qt),qt.matrix.fromArray(xe.transform.matrix),qt.matrix.decompose(qt.position,qt.quaternion,qt.scale),qt.projectionMatrix.fromArray(xe.projectionMatrix),
qt.projectionMatrixInverse.copy(qt.projectionMatrix).invert(),qt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),U===0&&(O.matrix.copy(qt.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Ot===!0&&O.cameras.push(qt)}let _t=s.enabledFeatures;if(_t&&_t.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=n.getBinding();let U=u.getDepthInformation(Mt[0]);U&&U.isValid&&U.texture&&m.init(
U,s.renderState)}if(_t&&_t.includes("camera-access")&&_){t.state.unbindTexture(),u=n.getBinding();for(let U=0;U<Mt.length;U++){let xe=Mt[U].camera;if(xe){let Kt=p[xe];Kt||(Kt=new fa,p[xe]=Kt);let qt=u.getCameraImage(xe);Kt.sourceTexture=qt}}}}for(let Mt=0;Mt<I.length;Mt++){let Ot=A[Mt],_t=I[Mt];Ot!==null&&_t!==void 0&&_t.update(Ot,tt,l||o)}pt&&pt(Q,tt),tt.detectedPlanes&&n.dispatchEvent({type:"pla\
nesdetected",data:tt}),g=null}let Zt=new c0;Zt.setAnimationLoop(ee),this.setAnimationLoop=function(Q){pt=Q},this.dispose=function(){}}},fr=new pi,N1=new ge;function O1(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,pf(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}
function s(m,p,b,T,y){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,y)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),_(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&
a(m,p)):p.isPointsMaterial?c(m,p,b,T):p.isSpriteMaterial?l(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.
alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===zn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===zn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.
value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let b=t.
get(p),T=b.envMap,y=b.envMapRotation;T&&(m.envMap.value=T,fr.copy(y),fr.x*=-1,fr.y*=-1,fr.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(fr.y*=-1,fr.z*=-1),m.envMapRotation.value.setFromMatrix4(N1.makeRotationFromEuler(fr)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.
lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.
value=p.dashSize+p.gapSize,m.scale.value=p.scale}function c(m,p,b,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*b,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function l(m,p){m.diffuse.value.copy(p.color),m.opacity.value=
p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.
value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,b){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),
m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,
e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===zn&&m.clearcoatNormalScale.
value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.
iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),
m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=
p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}
function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function _(m,p){let b=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function B1(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function c(b,T){let y=T.
program;n.uniformBlockBinding(b,y)}function l(b,T){let y=s[b.id];y===void 0&&(g(b),y=h(b),s[b.id]=y,b.addEventListener("dispose",m));let I=T.program;n.updateUBOMapping(b,I);let A=t.render.frame;r[b.id]!==A&&(f(b),r[b.id]=A)}function h(b){let T=u();b.__bindingPointIndex=T;let y=i.createBuffer(),I=b.__size,A=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,I,A),i.bindBuffer(
i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,y),y}function u(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let T=s[b.id],y=b.uniforms,I=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let A=0,D=y.length;A<D;A++){let N=Array.isArray(y[A])?y[A]:[y[A]];
for(let w=0,S=N.length;w<S;w++){let C=N[w];if(d(C,A,w,I)===!0){let O=C.__offset,z=Array.isArray(C.value)?C.value:[C.value],G=0;for(let X=0;X<z.length;X++){let q=z[X],Z=_(q);typeof q=="number"||typeof q=="boolean"?(C.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,O+G,C.__data)):q.isMatrix3?(C.__data[0]=q.elements[0],C.__data[1]=q.elements[1],C.__data[2]=q.elements[2],C.__data[3]=0,C.__data[4]=q.elements[3],
C.__data[5]=q.elements[4],C.__data[6]=q.elements[5],C.__data[7]=0,C.__data[8]=q.elements[6],C.__data[9]=q.elements[7],C.__data[10]=q.elements[8],C.__data[11]=0):(q.toArray(C.__data,G),G+=Z.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,O,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(b,T,y,I){let A=b.value,D=T+"_"+y;if(I[D]===void 0)return typeof A=="number"||
typeof A=="boolean"?I[D]=A:I[D]=A.clone(),!0;{let N=I[D];if(typeof A=="number"||typeof A=="boolean"){if(N!==A)return I[D]=A,!0}else if(N.equals(A)===!1)return N.copy(A),!0}return!1}function g(b){let T=b.uniforms,y=0,I=16;for(let D=0,N=T.length;D<N;D++){let w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,C=w.length;S<C;S++){let O=w[S],z=Array.isArray(O.value)?O.value:[O.value];for(let G=0,X=z.length;G<
X;G++){let q=z[G],Z=_(q),j=y%I,rt=j%Z.boundary,ot=j+rt;y+=rt,ot!==0&&I-ot<Z.storage&&(y+=I-ot),O.__data=new Float32Array(Z.storage/Float32Array.BYTES_PER_ELEMENT),O.__offset=y,y+=Z.storage}}}let A=y%I;return A>0&&(y+=I-A),b.__size=y,b.__cache={},this}function _(b){let T={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(T.boundary=4,T.storage=4):b.isVector2?(T.boundary=8,T.storage=
8):b.isVector3||b.isColor?(T.boundary=16,T.storage=12):b.isVector4?(T.boundary=16,T.storage=16):b.isMatrix3?(T.boundary=48,T.storage=48):b.isMatrix4?(T.boundary=64,T.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),T}function m(b){let T=b.target;T.removeEventListener(
"dispose",m);let y=o.indexOf(T.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:c,update:l,dispose:p}}var ch=class{constructor(t={}){let{canvas:e=Fg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="\
default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;let g=new Uint32Array(4),_=new Int32Array(4),m=null,p=null,b=[],T=[];this.domElement=e,this.debug=
{checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=us,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let y=this,I=!1;this._outputColorSpace=si;let A=0,D=0,N=null,w=-1,S=null,C=new je,O=new je,z=null,G=new ae(0),X=0,q=e.
width,Z=e.height,j=1,rt=null,ot=null,vt=new je(0,0,q,Z),xt=new je(0,0,q,Z),pt=!1,ee=new ao,Zt=!1,Q=!1,tt=new ge,Mt=new W,Ot=new je,_t={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function Pe(){return N===null?j:1}let U=n;function xe(E,V){return e.getContext(E,V)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,
failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",dt,!1),e.addEventListener("webglcontextrestored",It,!1),e.addEventListener("webglcontextcreationerror",ct,!1),U===null){let V="webgl2";if(U=xe(V,E),U===null)throw xe(V)?new Error("Error creating WebGL context with your selected attributes."):new Error("Err\
or creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let Kt,qt,Ft,Ie,Pt,Xt,He,Ee,P,x,F,J,nt,et,Nt,ht,Lt,At,at,gt,zt,kt,yt,te;function B(){Kt=new nS(U),Kt.init(),kt=new D1(U,Kt),qt=new Zb(U,Kt,t,kt),Ft=new I1(U,Kt),qt.reversedDepthBuffer&&f&&Ft.buffers.depth.setReversed(!0),Ie=new rS(U),Pt=new _1,Xt=new L1(U,Kt,Ft,Pt,qt,kt,Ie),He=new Kb(y),Ee=new eS(y),P=new uy(
U),yt=new Yb(U,P),x=new iS(U,P,Ie,yt),F=new aS(U,x,P,Ie),at=new oS(U,qt,Xt),ht=new Jb(Pt),J=new v1(y,He,Ee,Kt,qt,yt,ht),nt=new O1(y,Pt),et=new y1,Nt=new T1(Kt),At=new qb(y,He,Ee,Ft,F,d,c),Lt=new R1(y,F,qt),te=new B1(U,Ie,qt,Ft),gt=new $b(U,Kt,Ie),zt=new sS(U,Kt,Ie),Ie.programs=J.programs,y.capabilities=qt,y.extensions=Kt,y.properties=Pt,y.renderLists=et,y.shadowMap=Lt,y.state=Ft,y.info=Ie}B();let ut=new If(
y,U);this.xr=ut,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let E=Kt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Kt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return j},this.setPixelRatio=function(E){E!==void 0&&(j=E,this.setSize(
q,Z,!1))},this.getSize=function(E){return E.set(q,Z)},this.setSize=function(E,V,K=!0){if(ut.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=E,Z=V,e.width=Math.floor(E*j),e.height=Math.floor(V*j),K===!0&&(e.style.width=E+"px",e.style.height=V+"px"),this.setViewport(0,0,E,V)},this.getDrawingBufferSize=function(E){return E.set(q*j,Z*j).floor()},
this.setDrawingBufferSize=function(E,V,K){q=E,Z=V,j=K,e.width=Math.floor(E*K),e.height=Math.floor(V*K),this.setViewport(0,0,E,V)},this.getCurrentViewport=function(E){return E.copy(C)},this.getViewport=function(E){return E.copy(vt)},this.setViewport=function(E,V,K,$){E.isVector4?vt.set(E.x,E.y,E.z,E.w):vt.set(E,V,K,$),Ft.viewport(C.copy(vt).multiplyScalar(j).round())},this.getScissor=function(E){return E.
copy(xt)},this.setScissor=function(E,V,K,$){E.isVector4?xt.set(E.x,E.y,E.z,E.w):xt.set(E,V,K,$),Ft.scissor(O.copy(xt).multiplyScalar(j).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(E){Ft.setScissorTest(pt=E)},this.setOpaqueSort=function(E){rt=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(At.getClearColor())},this.setClearColor=
function(){At.setClearColor(...arguments)},this.getClearAlpha=function(){return At.getClearAlpha()},this.setClearAlpha=function(){At.setClearAlpha(...arguments)},this.clear=function(E=!0,V=!0,K=!0){let $=0;if(E){let H=!1;if(N!==null){let ft=N.texture.format;H=ft===Rc||ft===Cc||ft===Ac}if(H){let ft=N.texture.type,bt=ft===Li||ft===Ds||ft===_o||ft===yo||ft===wc||ft===Ec,Dt=At.getClearColor(),wt=At.getClearAlpha(),
$t=Dt.r,Jt=Dt.g,Gt=Dt.b;bt?(g[0]=$t,g[1]=Jt,g[2]=Gt,g[3]=wt,U.clearBufferuiv(U.COLOR,0,g)):(_[0]=$t,_[1]=Jt,_[2]=Gt,_[3]=wt,U.clearBufferiv(U.COLOR,0,_))}else $|=U.COLOR_BUFFER_BIT}V&&($|=U.DEPTH_BUFFER_BIT),K&&($|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=
function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",dt,!1),e.removeEventListener("webglcontextrestored",It,!1),e.removeEventListener("webglcontextcreationerror",ct,!1),At.dispose(),et.dispose(),Nt.dispose(),Pt.dispose(),He.dispose(),Ee.dispose(),F.dispose(),yt.dispose(),te.dispose(),J.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Ne),ut.
removeEventListener("sessionend",$n),Vn.stop()};function dt(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function It(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let E=Ie.autoReset,V=Lt.enabled,K=Lt.autoUpdate,$=Lt.needsUpdate,H=Lt.type;B(),Ie.autoReset=E,Lt.enabled=V,Lt.autoUpdate=K,Lt.needsUpdate=$,Lt.type=H}function ct(E){console.error("THREE.WebG\
LRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function st(E){let V=E.target;V.removeEventListener("dispose",st),Bt(V)}function Bt(E){ne(E),Pt.remove(E)}function ne(E){let V=Pt.get(E).programs;V!==void 0&&(V.forEach(function(K){J.releaseProgram(K)}),E.isShaderMaterial&&J.releaseShaderCache(E))}this.renderBufferDirect=function(E,V,K,$,H,ft){V===null&&(V=_t);let bt=H.isMesh&&
H.matrixWorld.determinant()<0,Dt=$i(E,V,K,$,H);Ft.setMaterial($,bt);let wt=K.index,$t=1;if($.wireframe===!0){if(wt=x.getWireframeAttribute(K),wt===void 0)return;$t=2}let Jt=K.drawRange,Gt=K.attributes.position,le=Jt.start*$t,be=(Jt.start+Jt.count)*$t;ft!==null&&(le=Math.max(le,ft.start*$t),be=Math.min(be,(ft.start+ft.count)*$t)),wt!==null?(le=Math.max(le,0),be=Math.min(be,wt.count)):Gt!=null&&(le=
Math.max(le,0),be=Math.min(be,Gt.count));let ke=be-le;if(ke<0||ke===1/0)return;yt.setup(H,$,Dt,K,wt);let Le,re=gt;if(wt!==null&&(Le=P.get(wt),re=zt,re.setIndex(Le)),H.isMesh)$.wireframe===!0?(Ft.setLineWidth($.wireframeLinewidth*Pe()),re.setMode(U.LINES)):re.setMode(U.TRIANGLES);else if(H.isLine){let Yt=$.linewidth;Yt===void 0&&(Yt=1),Ft.setLineWidth(Yt*Pe()),H.isLineSegments?re.setMode(U.LINES):H.
isLineLoop?re.setMode(U.LINE_LOOP):re.setMode(U.LINE_STRIP)}else H.isPoints?re.setMode(U.POINTS):H.isSprite&&re.setMode(U.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)no("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),re.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,
H._multiDrawCount,H._multiDrawInstances);else if(Kt.get("WEBGL_multi_draw"))re.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{let Yt=H._multiDrawStarts,ze=H._multiDrawCounts,fe=H._multiDrawCount,En=wt?P.get(wt).bytesPerElement:1,ds=Pt.get($).currentProgram.getUniforms();for(let Ln=0;Ln<fe;Ln++)ds.setValue(U,"_gl_DrawID",Ln),re.render(Yt[Ln]/En,ze[Ln])}else if(H.isInstancedMesh)
re.renderInstances(le,ke,H.count);else if(K.isInstancedBufferGeometry){let Yt=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,ze=Math.min(K.instanceCount,Yt);re.renderInstances(le,ke,ze)}else re.render(le,ke)};function Ue(E,V,K){E.transparent===!0&&E.side===mi&&E.forceSinglePass===!1?(E.side=zn,E.needsUpdate=!0,Fs(E,V,K),E.side=os,E.needsUpdate=!0,Fs(E,V,K),E.side=mi):Fs(E,V,K)}this.compile=function(E,V,K=null){
K===null&&(K=E),p=Nt.get(K),p.init(V),T.push(p),K.traverseVisible(function(H){H.isLight&&H.layers.test(V.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),E!==K&&E.traverseVisible(function(H){H.isLight&&H.layers.test(V.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();let $=new Set;return E.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;
let ft=H.material;if(ft)if(Array.isArray(ft))for(let bt=0;bt<ft.length;bt++){let Dt=ft[bt];Ue(Dt,K,H),$.add(Dt)}else Ue(ft,K,H),$.add(ft)}),p=T.pop(),$},this.compileAsync=function(E,V,K=null){let $=this.compile(E,V,K);return new Promise(H=>{function ft(){if($.forEach(function(bt){Pt.get(bt).currentProgram.isReady()&&$.delete(bt)}),$.size===0){H(E);return}setTimeout(ft,10)}Kt.get("KHR_parallel_shad\
er_compile")!==null?ft():setTimeout(ft,10)})};let Me=null;function yn(E){Me&&Me(E)}function Ne(){Vn.stop()}function $n(){Vn.start()}let Vn=new c0;Vn.setAnimationLoop(yn),typeof self<"u"&&Vn.setContext(self),this.setAnimationLoop=function(E){Me=E,ut.setAnimationLoop(E),E===null?Vn.stop():Vn.start()},ut.addEventListener("sessionstart",Ne),ut.addEventListener("sessionend",$n),this.render=function(E,V){
if(V!==void 0&&V.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(V),V=ut.getCamera()),E.isScene===!0&&E.onBeforeRender(
y,E,V,N),p=Nt.get(E,T.length),p.init(V),T.push(p),tt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),ee.setFromProjectionMatrix(tt,Ri,V.reversedDepth),Q=this.localClippingEnabled,Zt=ht.init(this.clippingPlanes,Q),m=et.get(E,b.length),m.init(),b.push(m),ut.enabled===!0&&ut.isPresenting===!0){let ft=y.xr.getDepthSensingMesh();ft!==null&&Ui(ft,V,-1/0,y.sortObjects)}Ui(E,V,0,y.sortObjects),m.
finish(),y.sortObjects===!0&&m.sort(rt,ot),Qt=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Qt&&At.addToRenderList(m,E),this.info.render.frame++,Zt===!0&&ht.beginShadows();let K=p.state.shadowsArray;Lt.render(K,E,V),Zt===!0&&ht.endShadows(),this.info.autoReset===!0&&this.info.reset();let $=m.opaque,H=m.transmissive;if(p.setupLights(),V.isArrayCamera){let ft=V.cameras;if(H.length>
0)for(let bt=0,Dt=ft.length;bt<Dt;bt++){let wt=ft[bt];Yi($,H,E,wt)}Qt&&At.render(E);for(let bt=0,Dt=ft.length;bt<Dt;bt++){let wt=ft[bt];In(m,E,wt,wt.viewport)}}else H.length>0&&Yi($,H,E,V),Qt&&At.render(E),In(m,E,V);N!==null&&D===0&&(Xt.updateMultisampleRenderTarget(N),Xt.updateRenderTargetMipmap(N)),E.isScene===!0&&E.onAfterRender(y,E,V),yt.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.
length-1],Zt===!0&&ht.setGlobalState(y.clippingPlanes,p.state.camera)):p=null,b.pop(),b.length>0?m=b[b.length-1]:m=null};function Ui(E,V,K,$){if(E.visible===!1)return;if(E.layers.test(V.layers)){if(E.isGroup)K=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(V);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||ee.intersectsSprite(E)){$&&
Ot.setFromMatrixPosition(E.matrixWorld).applyMatrix4(tt);let bt=F.update(E),Dt=E.material;Dt.visible&&m.push(E,bt,Dt,K,Ot.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||ee.intersectsObject(E))){let bt=F.update(E),Dt=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ot.copy(E.boundingSphere.center)):(bt.boundingSphere===null&&bt.computeBoundingSphere(),
Ot.copy(bt.boundingSphere.center)),Ot.applyMatrix4(E.matrixWorld).applyMatrix4(tt)),Array.isArray(Dt)){let wt=bt.groups;for(let $t=0,Jt=wt.length;$t<Jt;$t++){let Gt=wt[$t],le=Dt[Gt.materialIndex];le&&le.visible&&m.push(E,bt,le,K,Ot.z,Gt)}}else Dt.visible&&m.push(E,bt,Dt,K,Ot.z,null)}}let ft=E.children;for(let bt=0,Dt=ft.length;bt<Dt;bt++)Ui(ft[bt],V,K,$)}function In(E,V,K,$){let H=E.opaque,ft=E.transmissive,
bt=E.transparent;p.setupLightsView(K),Zt===!0&&ht.setGlobalState(y.clippingPlanes,K),$&&Ft.viewport(C.copy($)),H.length>0&&vi(H,V,K),ft.length>0&&vi(ft,V,K),bt.length>0&&vi(bt,V,K),Ft.buffers.depth.setTest(!0),Ft.buffers.depth.setMask(!0),Ft.buffers.color.setMask(!0),Ft.setPolygonOffset(!1)}function Yi(E,V,K,$){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[$.
id]===void 0&&(p.state.transmissionRenderTarget[$.id]=new Hi(1,1,{generateMipmaps:!0,type:Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float")?xo:Li,minFilter:Ls,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ye.workingColorSpace}));let ft=p.state.transmissionRenderTarget[$.id],bt=$.viewport||C;ft.setSize(bt.z*y.transmissionResolutionScale,bt.
w*y.transmissionResolutionScale);let Dt=y.getRenderTarget(),wt=y.getActiveCubeFace(),$t=y.getActiveMipmapLevel();y.setRenderTarget(ft),y.getClearColor(G),X=y.getClearAlpha(),X<1&&y.setClearColor(16777215,.5),y.clear(),Qt&&At.render(K);let Jt=y.toneMapping;y.toneMapping=us;let Gt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),p.setupLightsView($),Zt===!0&&ht.setGlobalState(y.clippingPlanes,
$),vi(E,K,$),Xt.updateMultisampleRenderTarget(ft),Xt.updateRenderTargetMipmap(ft),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let le=!1;for(let be=0,ke=V.length;be<ke;be++){let Le=V[be],re=Le.object,Yt=Le.geometry,ze=Le.material,fe=Le.group;if(ze.side===mi&&re.layers.test($.layers)){let En=ze.side;ze.side=zn,ze.needsUpdate=!0,To(re,K,$,Yt,ze,fe),ze.side=En,ze.needsUpdate=!0,le=!0}}le===!0&&
(Xt.updateMultisampleRenderTarget(ft),Xt.updateRenderTargetMipmap(ft))}y.setRenderTarget(Dt,wt,$t),y.setClearColor(G,X),Gt!==void 0&&($.viewport=Gt),y.toneMapping=Jt}function vi(E,V,K){let $=V.isScene===!0?V.overrideMaterial:null;for(let H=0,ft=E.length;H<ft;H++){let bt=E[H],Dt=bt.object,wt=bt.geometry,$t=bt.group,Jt=bt.material;Jt.allowOverride===!0&&$!==null&&(Jt=$),Dt.layers.test(K.layers)&&To(
Dt,V,K,wt,Jt,$t)}}function To(E,V,K,$,H,ft){E.onBeforeRender(y,V,K,$,H,ft),E.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),H.onBeforeRender(y,V,K,$,E,ft),H.transparent===!0&&H.side===mi&&H.forceSinglePass===!1?(H.side=zn,H.needsUpdate=!0,y.renderBufferDirect(K,V,$,H,E,ft),H.side=os,H.needsUpdate=!0,y.renderBufferDirect(K,V,$,
H,E,ft),H.side=mi):y.renderBufferDirect(K,V,$,H,E,ft),E.onAfterRender(y,V,K,$,H,ft)}function Fs(E,V,K){V.isScene!==!0&&(V=_t);let $=Pt.get(E),H=p.state.lights,ft=p.state.shadowsArray,bt=H.state.version,Dt=J.getParameters(E,H.state,ft,V,K),wt=J.getProgramCacheKey(Dt),$t=$.programs;$.environment=E.isMeshStandardMaterial?V.environment:null,$.fog=V.fog,$.envMap=(E.isMeshStandardMaterial?Ee:He).get(E.envMap||
$.environment),$.envMapRotation=$.environment!==null&&E.envMap===null?V.environmentRotation:E.envMapRotation,$t===void 0&&(E.addEventListener("dispose",st),$t=new Map,$.programs=$t);let Jt=$t.get(wt);if(Jt!==void 0){if($.currentProgram===Jt&&$.lightsStateVersion===bt)return Pa(E,Dt),Jt}else Dt.uniforms=J.getUniforms(E),E.onBeforeCompile(Dt,y),Jt=J.acquireProgram(Dt,wt),$t.set(wt,Jt),$.uniforms=Dt.
uniforms;let Gt=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Gt.clippingPlanes=ht.uniform),Pa(E,Dt),$.needsLights=Ns(E),$.lightsStateVersion=bt,$.needsLights&&(Gt.ambientLightColor.value=H.state.ambient,Gt.lightProbe.value=H.state.probe,Gt.directionalLights.value=H.state.directional,Gt.directionalLightShadows.value=H.state.directionalShadow,Gt.spotLights.value=
H.state.spot,Gt.spotLightShadows.value=H.state.spotShadow,Gt.rectAreaLights.value=H.state.rectArea,Gt.ltc_1.value=H.state.rectAreaLTC1,Gt.ltc_2.value=H.state.rectAreaLTC2,Gt.pointLights.value=H.state.point,Gt.pointLightShadows.value=H.state.pointShadow,Gt.hemisphereLights.value=H.state.hemi,Gt.directionalShadowMap.value=H.state.directionalShadowMap,Gt.directionalShadowMatrix.value=H.state.directionalShadowMatrix,
Gt.spotShadowMap.value=H.state.spotShadowMap,Gt.spotLightMatrix.value=H.state.spotLightMatrix,Gt.spotLightMap.value=H.state.spotLightMap,Gt.pointShadowMap.value=H.state.pointShadowMap,Gt.pointShadowMatrix.value=H.state.pointShadowMatrix),$.currentProgram=Jt,$.uniformsList=null,Jt}function Ra(E){if(E.uniformsList===null){let V=E.currentProgram.getUniforms();E.uniformsList=wo.seqWithValue(V.seq,E.uniforms)}
return E.uniformsList}function Pa(E,V){let K=Pt.get(E);K.outputColorSpace=V.outputColorSpace,K.batching=V.batching,K.batchingColor=V.batchingColor,K.instancing=V.instancing,K.instancingColor=V.instancingColor,K.instancingMorph=V.instancingMorph,K.skinning=V.skinning,K.morphTargets=V.morphTargets,K.morphNormals=V.morphNormals,K.morphColors=V.morphColors,K.morphTargetsCount=V.morphTargetsCount,K.numClippingPlanes=
V.numClippingPlanes,K.numIntersection=V.numClipIntersection,K.vertexAlphas=V.vertexAlphas,K.vertexTangents=V.vertexTangents,K.toneMapping=V.toneMapping}function $i(E,V,K,$,H){V.isScene!==!0&&(V=_t),Xt.resetTextureUnits();let ft=V.fog,bt=$.isMeshStandardMaterial?V.environment:null,Dt=N===null?y.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:nr,wt=($.isMeshStandardMaterial?Ee:He).get(
$.envMap||bt),$t=$.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,Jt=!!K.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Gt=!!K.morphAttributes.position,le=!!K.morphAttributes.normal,be=!!K.morphAttributes.color,ke=us;$.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(ke=y.toneMapping);let Le=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,
re=Le!==void 0?Le.length:0,Yt=Pt.get($),ze=p.state.lights;if(Zt===!0&&(Q===!0||E!==S)){let un=E===S&&$.id===w;ht.setState($,E,un)}let fe=!1;$.version===Yt.__version?(Yt.needsLights&&Yt.lightsStateVersion!==ze.state.version||Yt.outputColorSpace!==Dt||H.isBatchedMesh&&Yt.batching===!1||!H.isBatchedMesh&&Yt.batching===!0||H.isBatchedMesh&&Yt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&
Yt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&Yt.instancing===!1||!H.isInstancedMesh&&Yt.instancing===!0||H.isSkinnedMesh&&Yt.skinning===!1||!H.isSkinnedMesh&&Yt.skinning===!0||H.isInstancedMesh&&Yt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&Yt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&Yt.instancingMorph===!0&&H.morphTexture===null||H.
isInstancedMesh&&Yt.instancingMorph===!1&&H.morphTexture!==null||Yt.envMap!==wt||$.fog===!0&&Yt.fog!==ft||Yt.numClippingPlanes!==void 0&&(Yt.numClippingPlanes!==ht.numPlanes||Yt.numIntersection!==ht.numIntersection)||Yt.vertexAlphas!==$t||Yt.vertexTangents!==Jt||Yt.morphTargets!==Gt||Yt.morphNormals!==le||Yt.morphColors!==be||Yt.toneMapping!==ke||Yt.morphTargetsCount!==re)&&(fe=!0):(fe=!0,Yt.__version=
$.version);let En=Yt.currentProgram;fe===!0&&(En=Fs($,V,H));let ds=!1,Ln=!1,Os=!1,Ve=En.getUniforms(),Dn=Yt.uniforms;if(Ft.useProgram(En.program)&&(ds=!0,Ln=!0,Os=!0),$.id!==w&&(w=$.id,Ln=!0),ds||S!==E){Ft.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),Ve.setValue(U,"projectionMatrix",E.projectionMatrix),Ve.setValue(U,"viewMatrix",E.matrixWorldInverse);
let fn=Ve.map.cameraPosition;fn!==void 0&&fn.setValue(U,Mt.setFromMatrixPosition(E.matrixWorld)),qt.logarithmicDepthBuffer&&Ve.setValue(U,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Ve.setValue(U,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,Ln=
!0,Os=!0)}if(H.isSkinnedMesh){Ve.setOptional(U,H,"bindMatrix"),Ve.setOptional(U,H,"bindMatrixInverse");let un=H.skeleton;un&&(un.boneTexture===null&&un.computeBoneTexture(),Ve.setValue(U,"boneTexture",un.boneTexture,Xt))}H.isBatchedMesh&&(Ve.setOptional(U,H,"batchingTexture"),Ve.setValue(U,"batchingTexture",H._matricesTexture,Xt),Ve.setOptional(U,H,"batchingIdTexture"),Ve.setValue(U,"batchingIdTex\
ture",H._indirectTexture,Xt),Ve.setOptional(U,H,"batchingColorTexture"),H._colorsTexture!==null&&Ve.setValue(U,"batchingColorTexture",H._colorsTexture,Xt));let Hn=K.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&at.update(H,K,En),(Ln||Yt.receiveShadow!==H.receiveShadow)&&(Yt.receiveShadow=H.receiveShadow,Ve.setValue(U,"receiveShadow",H.receiveShadow)),$.isMeshGouraudMaterial&&
$.envMap!==null&&(Dn.envMap.value=wt,Dn.flipEnvMap.value=wt.isCubeTexture&&wt.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&V.environment!==null&&(Dn.envMapIntensity.value=V.environmentIntensity),Ln&&(Ve.setValue(U,"toneMappingExposure",y.toneMappingExposure),Yt.needsLights&&ph(Dn,Os),ft&&$.fog===!0&&nt.refreshFogUniforms(Dn,ft),nt.refreshMaterialUniforms(Dn,$,j,Z,p.state.
transmissionRenderTarget[E.id]),wo.upload(U,Ra(Yt),Dn,Xt)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(wo.upload(U,Ra(Yt),Dn,Xt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Ve.setValue(U,"center",H.center),Ve.setValue(U,"modelViewMatrix",H.modelViewMatrix),Ve.setValue(U,"normalMatrix",H.normalMatrix),Ve.setValue(U,"modelMatrix",H.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){let un=$.
uniformsGroups;for(let fn=0,ps=un.length;fn<ps;fn++){let oi=un[fn];te.update(oi,En),te.bind(oi,En)}}return En}function ph(E,V){E.ambientLightColor.needsUpdate=V,E.lightProbe.needsUpdate=V,E.directionalLights.needsUpdate=V,E.directionalLightShadows.needsUpdate=V,E.pointLights.needsUpdate=V,E.pointLightShadows.needsUpdate=V,E.spotLights.needsUpdate=V,E.spotLightShadows.needsUpdate=V,E.rectAreaLights.
needsUpdate=V,E.hemisphereLights.needsUpdate=V}function Ns(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(E,V,K){let $=Pt.
get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Pt.get(E.texture).__webglTexture=V,Pt.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:K,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,V){let K=Pt.get(E);K.__webglFramebuffer=V,K.__useDefaultFramebuffer=V===void 0};let Ia=U.createFramebuffer();
this.setRenderTarget=function(E,V=0,K=0){N=E,A=V,D=K;let $=!0,H=null,ft=!1,bt=!1;if(E){let wt=Pt.get(E);if(wt.__useDefaultFramebuffer!==void 0)Ft.bindFramebuffer(U.FRAMEBUFFER,null),$=!1;else if(wt.__webglFramebuffer===void 0)Xt.setupRenderTarget(E);else if(wt.__hasExternalTextures)Xt.rebindTextures(E,Pt.get(E.texture).__webglTexture,Pt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Gt=E.
depthTexture;if(wt.__boundDepthTexture!==Gt){if(Gt!==null&&Pt.has(Gt)&&(E.width!==Gt.image.width||E.height!==Gt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(E)}}let $t=E.texture;($t.isData3DTexture||$t.isDataArrayTexture||$t.isCompressedArrayTexture)&&(bt=!0);let Jt=Pt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?
(Array.isArray(Jt[V])?H=Jt[V][K]:H=Jt[V],ft=!0):E.samples>0&&Xt.useMultisampledRTT(E)===!1?H=Pt.get(E).__webglMultisampledFramebuffer:Array.isArray(Jt)?H=Jt[K]:H=Jt,C.copy(E.viewport),O.copy(E.scissor),z=E.scissorTest}else C.copy(vt).multiplyScalar(j).floor(),O.copy(xt).multiplyScalar(j).floor(),z=pt;if(K!==0&&(H=Ia),Ft.bindFramebuffer(U.FRAMEBUFFER,H)&&$&&Ft.drawBuffers(E,H),Ft.viewport(C),Ft.scissor(
O),Ft.setScissorTest(z),ft){let wt=Pt.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+V,wt.__webglTexture,K)}else if(bt){let wt=V;for(let $t=0;$t<E.textures.length;$t++){let Jt=Pt.get(E.textures[$t]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+$t,Jt.__webglTexture,K,wt)}}else if(E!==null&&K!==0){let wt=Pt.get(E.texture);U.framebufferTexture2D(
U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,wt.__webglTexture,K)}w=-1},this.readRenderTargetPixels=function(E,V,K,$,H,ft,bt,Dt=0){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let wt=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&bt!==void 0&&(wt=wt[bt]),wt){Ft.bindFramebuffer(U.FRAMEBUFFER,
wt);try{let $t=E.textures[Dt],Jt=$t.format,Gt=$t.type;if(!qt.textureFormatReadable(Jt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!qt.textureTypeReadable(Gt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=E.
width-$&&K>=0&&K<=E.height-H&&(E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Dt),U.readPixels(V,K,$,H,kt.convert(Jt),kt.convert(Gt),ft))}finally{let $t=N!==null?Pt.get(N).__webglFramebuffer:null;Ft.bindFramebuffer(U.FRAMEBUFFER,$t)}}},this.readRenderTargetPixelsAsync=async function(E,V,K,$,H,ft,bt,Dt=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPix\
els: renderTarget is not THREE.WebGLRenderTarget.");let wt=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&bt!==void 0&&(wt=wt[bt]),wt)if(V>=0&&V<=E.width-$&&K>=0&&K<=E.height-H){Ft.bindFramebuffer(U.FRAMEBUFFER,wt);let $t=E.textures[Dt],Jt=$t.format,Gt=$t.type;if(!qt.textureFormatReadable(Jt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA \
or implementation defined format.");if(!qt.textureTypeReadable(Gt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let le=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,le),U.bufferData(U.PIXEL_PACK_BUFFER,ft.byteLength,U.STREAM_READ),E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Dt),U.readPixels(
V,K,$,H,kt.convert(Jt),kt.convert(Gt),0);let be=N!==null?Pt.get(N).__webglFramebuffer:null;Ft.bindFramebuffer(U.FRAMEBUFFER,be);let ke=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Ng(U,ke,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,le),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,ft),U.deleteBuffer(le),U.deleteSync(ke),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAs\
ync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,V=null,K=0){let $=Math.pow(2,-K),H=Math.floor(E.image.width*$),ft=Math.floor(E.image.height*$),bt=V!==null?V.x:0,Dt=V!==null?V.y:0;Xt.setTexture2D(E,0),U.copyTexSubImage2D(U.TEXTURE_2D,K,0,0,bt,Dt,H,ft),Ft.unbindTexture()};let Fi=U.createFramebuffer(),on=U.createFramebuffer();this.copyTextureToTexture=function(E,V,K=null,$=null,H=0,ft=null){
ft===null&&(H!==0?(no("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),ft=H,H=0):ft=0);let bt,Dt,wt,$t,Jt,Gt,le,be,ke,Le=E.isCompressedTexture?E.mipmaps[ft]:E.image;if(K!==null)bt=K.max.x-K.min.x,Dt=K.max.y-K.min.y,wt=K.isBox3?K.max.z-K.min.z:1,$t=K.min.x,Jt=K.min.y,Gt=K.isBox3?K.min.z:0;else{let Hn=Math.pow(2,-H);bt=Math.floor(Le.width*Hn),
Dt=Math.floor(Le.height*Hn),E.isDataArrayTexture?wt=Le.depth:E.isData3DTexture?wt=Math.floor(Le.depth*Hn):wt=1,$t=0,Jt=0,Gt=0}$!==null?(le=$.x,be=$.y,ke=$.z):(le=0,be=0,ke=0);let re=kt.convert(V.format),Yt=kt.convert(V.type),ze;V.isData3DTexture?(Xt.setTexture3D(V,0),ze=U.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xt.setTexture2DArray(V,0),ze=U.TEXTURE_2D_ARRAY):(Xt.setTexture2D(
V,0),ze=U.TEXTURE_2D),U.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,V.flipY),U.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),U.pixelStorei(U.UNPACK_ALIGNMENT,V.unpackAlignment);let fe=U.getParameter(U.UNPACK_ROW_LENGTH),En=U.getParameter(U.UNPACK_IMAGE_HEIGHT),ds=U.getParameter(U.UNPACK_SKIP_PIXELS),Ln=U.getParameter(U.UNPACK_SKIP_ROWS),Os=U.getParameter(U.UNPACK_SKIP_IMAGES);U.pixelStorei(
U.UNPACK_ROW_LENGTH,Le.width),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Le.height),U.pixelStorei(U.UNPACK_SKIP_PIXELS,$t),U.pixelStorei(U.UNPACK_SKIP_ROWS,Jt),U.pixelStorei(U.UNPACK_SKIP_IMAGES,Gt);let Ve=E.isDataArrayTexture||E.isData3DTexture,Dn=V.isDataArrayTexture||V.isData3DTexture;if(E.isDepthTexture){let Hn=Pt.get(E),un=Pt.get(V),fn=Pt.get(Hn.__renderTarget),ps=Pt.get(un.__renderTarget);Ft.bindFramebuffer(
U.READ_FRAMEBUFFER,fn.__webglFramebuffer),Ft.bindFramebuffer(U.DRAW_FRAMEBUFFER,ps.__webglFramebuffer);for(let oi=0;oi<wt;oi++)Ve&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Pt.get(E).__webglTexture,H,Gt+oi),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Pt.get(V).__webglTexture,ft,ke+oi)),U.blitFramebuffer($t,Jt,bt,Dt,le,be,bt,Dt,U.DEPTH_BUFFER_BIT,U.NEAREST);
Ft.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ft.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(H!==0||E.isRenderTargetTexture||Pt.has(E)){let Hn=Pt.get(E),un=Pt.get(V);Ft.bindFramebuffer(U.READ_FRAMEBUFFER,Fi),Ft.bindFramebuffer(U.DRAW_FRAMEBUFFER,on);for(let fn=0;fn<wt;fn++)Ve?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Hn.__webglTexture,H,Gt+fn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,
U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Hn.__webglTexture,H),Dn?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,un.__webglTexture,ft,ke+fn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,un.__webglTexture,ft),H!==0?U.blitFramebuffer($t,Jt,bt,Dt,le,be,bt,Dt,U.COLOR_BUFFER_BIT,U.NEAREST):Dn?U.copyTexSubImage3D(ze,ft,le,be,ke+fn,$t,Jt,bt,Dt):U.copyTexSubImage2D(ze,
ft,le,be,$t,Jt,bt,Dt);Ft.bindFramebuffer(U.READ_FRAMEBUFFER,null),Ft.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Dn?E.isDataTexture||E.isData3DTexture?U.texSubImage3D(ze,ft,le,be,ke,bt,Dt,wt,re,Yt,Le.data):V.isCompressedArrayTexture?U.compressedTexSubImage3D(ze,ft,le,be,ke,bt,Dt,wt,re,Le.data):U.texSubImage3D(ze,ft,le,be,ke,bt,Dt,wt,re,Yt,Le):E.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,ft,le,be,
bt,Dt,re,Yt,Le.data):E.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,ft,le,be,Le.width,Le.height,re,Le.data):U.texSubImage2D(U.TEXTURE_2D,ft,le,be,bt,Dt,re,Yt,Le);U.pixelStorei(U.UNPACK_ROW_LENGTH,fe),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,En),U.pixelStorei(U.UNPACK_SKIP_PIXELS,ds),U.pixelStorei(U.UNPACK_SKIP_ROWS,Ln),U.pixelStorei(U.UNPACK_SKIP_IMAGES,Os),ft===0&&V.generateMipmaps&&U.generateMipmap(
ze),Ft.unbindTexture()},this.initRenderTarget=function(E){Pt.get(E).__webglFramebuffer===void 0&&Xt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Xt.setTextureCube(E,0):E.isData3DTexture?Xt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Xt.setTexture2DArray(E,0):Xt.setTexture2D(E,0),Ft.unbindTexture()},this.resetState=function(){A=0,D=0,N=null,Ft.reset(),yt.
reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};function Us(i,t,e=.8){let n=i.index?i.toNonIndexed():i,s=n.getAttribute("position"),r=new Float32Array(3*s.count);for(let o=0;o<s.count;o+=3){let a=l=>(l(o)+l(o+1)+l(o+2))/3,c=t(a(l=>s.getX(l)),a(l=>s.getY(l)),a(l=>s.getZ(l)))?e:1;r.fill(c,3*o,3*o+9)}return n.setAttribute("color",new _e(r,3)),n}function p0(i){if(!i)return Us(new po(1,40,24),(s,r,o)=>s*r*o>0);let t=new po(1,10,7),e=t.getAttribute("\
position"),n=Array.from({length:e.count},(s,r)=>e.getX(r)*e.getY(r)*e.getZ(r)>.01?.72:1);return t.setAttribute("color",new _e(n.flatMap(s=>[s,s,s]),3)),t}function Df(){let i=new uo(1,1,2,48).applyMatrix4(new ge().makeRotationX(Math.PI/2));return Us(i,(t,e)=>t*e>0)}function m0(i,t){let e=new da(i,2*t,12,28).applyMatrix4(new ge().makeRotationX(Math.PI/2));return Us(e,(n,s)=>n*s>0)}function g0(){let i=new pa(
1,2,48).applyMatrix4(new ge().makeRotationX(Math.PI/2).setPosition(0,0,1));return Us(i,(t,e)=>t*e>0)}function v0(i,t){return Us(new ma(i,t,20,64),(e,n)=>e*n>0)}function _0({points:i=[],triangles:t=[]}){let e=new en,n=t.flatMap(s=>s.flatMap(r=>i[r]));return e.setAttribute("position",new _e(n,3)),e.computeVertexNormals(),{solid:Us(e,()=>!1),edges:new fo(e,12)}}function x0(){return Us(new cs(2,2,2),()=>!1)}
function y0(){return new fo(new cs(2,2,2))}function M0(){let e=new Float32Array(435);for(let n=0;n<=144;++n){let s=n/144,r=2*Math.PI*9*s,o=Math.min(1,12*Math.min(s,1-s));e.set([o*Math.cos(r),o*Math.sin(r),s],3*n)}return e}function b0(i,t){let e=[0,0,0],n=0;for(let a=0;a<i.length;++a){let c=i[a],l=i[(a+1)%i.length];e=Rt(e,Ze(c,l)),n+=Tn(ue(l,c))}let s=On(e),r=Tt(i.reduce(Rt,[0,0,0]),1/i.length),o=Tn(
e)/Math.max(n,1e-12);for(let a of t)k1(r,a)&&(o=Math.max(o,1.08*a.thickness));return{points:i,n:s,thickness:o}}function k1(i,t){let{points:e,n}=t,s=Math.max(...e.map(r=>Tn(ue(r,e[0]))));return Math.abs(Ht(n,ue(i,e[0])))>.02*s?!1:e.every((r,o)=>Ht(n,Ze(ue(e[(o+1)%e.length],r),ue(i,r)))>=0)}function S0({points:i,n:t,thickness:e}){let n=Tt(t,e/2),s=[],r=[],o=i.map(h=>Rt(h,n)),a=i.map(h=>ue(h,n));for(let h=1;h+
1<i.length;++h)s.push(...o[0],...o[h],...o[h+1],...a[0],...a[h+1],...a[h]);for(let h=0;h<i.length;++h){let u=(h+1)%i.length;s.push(...o[h],...a[h],...a[u],...o[h],...a[u],...o[u]),r.push(...o[h],...o[u],...a[h],...a[u])}let c=new en,l=new en;return c.setAttribute("position",new _e(s,3)),c.computeVertexNormals(),l.setAttribute("position",new _e(r,3)),{solid:Us(c,()=>!1),edges:l}}function uh(i,t,e){
let n=ue(t,i),s=On(n),r=On(Ze(Math.abs(s[0])<.9?[1,0,0]:[0,1,0],s)),o=Ze(s,r),a=Tt(Rt(i,t),.5),c=Tn(n)/2,[l,h,u]=[Tt(r,e),Tt(o,e),Tt(s,c)];return new ge().set(l[0],h[0],u[0],a[0],l[1],h[1],u[1],a[1],l[2],h[2],u[2],a[2],0,0,0,1)}function w0(i,t){return i.kind==="capsule"?`capsule ${i.radius} ${i.halfLength}`:i.kind==="torus"?`torus ${i.radius} ${i.tube}`:i.kind==="polygon"||i.kind==="mesh"?`${i.kind}\
 ${t}`:i.kind==="ellipsoid"?"sphere":i.kind==="circle"?"cylinder":i.kind}var z1=1500,fh=class{constructor(t,e,n){this.model=e;this.scene=new la;this.eye=new Rn;this.flat=new ar;this.groups=[];this.links=[];this.grounds=[];this.sun=new _a(16777215,1.9);this.fill=new va(16777215,12107976,1.3);this.ambient=new xa(16777215,.55);this.used=this.eye;this.marked=-2;let{canvas:s,context:r,software:o}=H1(t,n);this.canvas=s,this.renderer=new ch({canvas:s,context:r,antialias:!o,preserveDrawingBuffer:!0}),
this.renderer.debug.checkShaderErrors=n,this.frames=Array.from({length:e.film.poses},()=>new ge);let a=o||e.bodies.length>z1;this.renderer.shadowMap.enabled=!a,this.renderer.shadowMap.type=fc,this.sun.castShadow=!a,this.sun.shadow.mapSize.set(2048,2048),this.sun.shadow.normalBias=.004*e.extent.size,this.sun.shadow.radius=4,this.scene.add(this.sun,this.sun.target,this.fill,this.ambient),this.addBodies(
a,e.bodies.length>200);for(let c of e.grounds)this.addGround(c,a);this.recolour()}addBodies(t,e){let n=new Map,s=new Map,r=(o,a)=>{let c=n.get(o);c?c.push(a):n.set(o,[a])};this.model.bodies.forEach((o,a)=>{if(o.kind==="link")this.addLink(o);else if(o.kind==="segment")for(let c of this.bars(o))r("cylinder",{frame:o.frame,local:c,shape:o});else r(w0(o,a),{frame:o.frame,local:G1(o),shape:o})});for(let[
o,a]of n){let{shape:c}=a[0],l=null,h;if(o==="sphere")h=p0(t&&e);else if(o==="box")h=x0(),l=y0();else if(o==="cylinder")h=Df();else if(o==="cone")h=g0();else if(c.kind==="torus")h=v0(c.radius??0,c.tube??0);else if(c.kind==="mesh")({solid:h,edges:l}=_0(c));else if(c.kind==="capsule")h=m0(c.radius??0,c.halfLength??0);else{let u=s.get(c.frame)??[],f=b0(c.points??[],u);s.set(c.frame,[...u,f]),{solid:h,
edges:l}=S0(f)}this.addGroup(a,h,l,t)}}addGroup(t,e,n,s){let r=s?new rr({vertexColors:!0}):new mo({vertexColors:!0,roughness:.62,metalness:0,side:mi}),o=new ha(e,r,t.length);o.frustumCulled=!1,o.castShadow=o.receiveShadow=!s;let a=n&&t.length<=300?t.map(()=>new ho(n,Uf({transparent:!0,opacity:.55}))):[];for(let h of a)h.matrixAutoUpdate=!1,h.frustumCulled=!1;this.scene.add(o,...a);let c=t.some(h=>this.
model.film.moves(h.frame)),l=c&&t.every(({frame:h,shape:u})=>h>=0&&u.kind==="sphere"&&u.position.every(f=>f===0)&&u.orientation[0]===1);this.groups.push({mesh:o,instances:t,moving:c,edges:a,balls:l}),this.place(this.groups[this.groups.length-1])}bars(t){let e=t.radius||.0022*this.model.extent.size,n=A0(t.position,t.orientation),s=t.points??[],r=[];for(let o=0;o+1<s.length;++o)r.push(new ge().multiplyMatrices(
n,uh(s[o],s[o+1],e)));return r}addLink(t){let e;if(t.style==="spring"){let n=new en().setAttribute("position",new _e(M0(),3));e=new co(n,Uf())}else e=new wn(Df(),new mo({vertexColors:!0,roughness:.6})),e.castShadow=!0;e.matrixAutoUpdate=!1,e.frustumCulled=!1,this.scene.add(e),this.links.push({shape:t,object:e})}addGround(t,e){let{lo:n,hi:s,size:r}=this.model.extent,{c:o,n:a}=this.model.plane(t,this.
model.film.begin),c=Fa(a),l=Ze(a,c),h=Tt(Rt(n,s),.5),u=ue(h,Tt(a,Ht(a,ue(h,o)))),f=.9*r,d=Vs(0,2*f,14).step,g=Math.ceil(f/d),_=[c,l].map(A=>Math.round(Ht(u,A)/d)*d-Ht(u,A)),m=Rt(u,Rt(Tt(c,_[0]),Tt(l,_[1]))),p={polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:4},b=new wn(new sr(2*g*d,2*g*d),e?new ir(p):new rr(p));b.receiveShadow=!e;let T=[],y=g*d;for(let A=-g;A<=g;++A)for(let[D,N]of[[c,l],
[l,c]]){let w=Rt(m,Tt(D,A*d));T.push(...Rt(w,Tt(N,-y)),...Rt(w,Tt(N,y)))}let I=new ho(new en().setAttribute("position",new _e(T,3)),Uf());b.matrixAutoUpdate=I.matrixAutoUpdate=!1,b.matrix.makeBasis(new W(...c),new W(...l),new W(...a)).setPosition(...m),this.scene.add(b,I),this.grounds.push({sheet:b,lines:I,shape:t})}recolour(t=this.marked){this.marked=t,this.renderer.setClearColor(se.paper);let e=se.
dark?.25:-.45,n=new ae(se.accent),s=new ae;for(let{mesh:r,instances:o,edges:a}of this.groups)o.forEach(({shape:c,frame:l},h)=>{let u=Cr(c);s.set(u),l>=0&&l===t&&s.lerp(n,.75),r.setColorAt(h,s),a[h]&&a[h].material.color.set(Je(u,e))}),r.instanceColor&&(r.instanceColor.needsUpdate=!0);for(let{shape:r,object:o}of this.links)o.material.color.set(Je(Cr(r),-.2));for(let{sheet:r,lines:o}of this.grounds){
let a=r.material instanceof rr;r.material.color.set(se.dark?"#2a323b":a?"#dfe4e9":"#e7edf4"),o.material.color.set(se.groundLine)}this.fill.intensity=se.dark?1.1:1.6}resize(t,e,n){this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1)}place(t){let e=new ge;t.balls?V1(t,this.model.film.now):t.instances.forEach(({frame:n,local:s},r)=>{n>=0?e.multiplyMatrices(this.frames[n],s):e.copy(s),t.mesh.setMatrixAt(
r,e),t.edges[r]&&t.edges[r].matrix.copy(e)}),t.mesh.instanceMatrix.needsUpdate=!0,t.mesh.boundingSphere=null}draw(t,e,n){n!==this.marked&&this.recolour(n);let s=this.model.film.sample(e);this.frames.forEach((r,o)=>X1(r,s,7*o));for(let r of this.groups)r.moving&&this.place(r);for(let{shape:r,object:o}of this.links)this.placeLink(r,o,e);this.aim(t),this.renderer.render(this.scene,this.used)}placeLink(t,e,n){
let[s,r]=[this.model.film.pose(t.frame,n),this.model.film.pose(t.frameEnd??-1,n)],[o,a]=t.points??[],c=Rt(s.r,vn(s.q,o??[0,0,0])),l=Rt(r.r,vn(r.q,a??[0,0,0])),h=this.model.extent.size;t.style==="spring"?e.matrix.copy(uh(ue(Tt(c,2),l),l,.018*h)):e.matrix.copy(uh(c,l,t.radius||.0025*h))}aim(t){let{size:e}=this.model.extent,n=t.hasDepth?t.distance:3*e,s=t.hasDepth?this.eye:this.flat;if(s.position.set(
...Rt(t.centre,Tt(t.toward,n))),s.up.set(...t.up),s.lookAt(...t.centre),s===this.eye)this.eye.fov=gu*180/Math.PI,this.eye.aspect=t.width/t.height,this.eye.near=Math.max(.02*n,n-4*e),this.eye.far=n+6*e,this.eye.updateProjectionMatrix();else{let[u,f]=[t.width/t.scale/2,t.height/t.scale/2];Object.assign(this.flat,{left:-u,right:u,top:f,bottom:-f,near:.01*e,far:8*e}),this.flat.updateProjectionMatrix()}
this.used=s;let r=t.upAxis===1?[0,1,0]:[0,0,1],o=t.isPlanar?Rt(Tt(t.toward,1.2),Rt(Tt(t.up,.9),Tt(t.right,-.5))):Rt(Tt(t.toward,.55),Rt(Tt(r,1.15),Tt(t.right,-.55))),{lo:a,hi:c}=this.model.extent,l=e>4/t.scale*t.height?t.centre:Tt(Rt(a,c),.5),h=Math.min(.75*e,.9*t.width/t.scale);this.sun.target.position.set(...l),this.sun.target.updateMatrixWorld(),this.sun.position.set(...Rt(l,Tt(o,2*e))),Object.
assign(this.sun.shadow.camera,{left:-h,right:h,top:h,bottom:-h,near:.1*e,far:6*e}),this.sun.shadow.camera.updateProjectionMatrix()}pick(t,e,n){let s=new ya;s.setFromCamera(new me(2*e/t.width-1,1-2*n/t.height),this.used);let r=1/0,o=-2;for(let{mesh:a,instances:c}of this.groups)for(let l of s.intersectObject(a,!1))l.distance<r&&l.instanceId!==void 0&&(r=l.distance,o=c[l.instanceId].frame);return o}};
function V1({mesh:i,instances:t},e){let n=i.instanceMatrix.array;for(let s=0;s<t.length;++s){let r=7*t[s].frame,o=t[s].shape.radius??1,a=16*s,c=e[r+3],l=e[r+4],h=e[r+5],u=e[r+6];n[a]=o*(1-2*(h*h+u*u)),n[a+1]=2*o*(l*h+c*u),n[a+2]=2*o*(l*u-c*h),n[a+4]=2*o*(l*h-c*u),n[a+5]=o*(1-2*(l*l+u*u)),n[a+6]=2*o*(h*u+c*l),n[a+8]=2*o*(l*u+c*h),n[a+9]=2*o*(h*u-c*l),n[a+10]=o*(1-2*(l*l+h*h)),n[a+12]=e[r],n[a+13]=e[r+
1],n[a+14]=e[r+2],n[a+15]=1}}function Uf(i={}){return Object.assign(new lo(i),{combine:vo})}function H1(i,t){let e=(a,c)=>{let l=a.getContext("webgl2",{preserveDrawingBuffer:!0,stencil:!1,antialias:c});if(!l)throw new Error("no WebGL");return l};i.width=innerWidth,i.height=innerHeight;let n=e(i,t),s=n.getExtension("WEBGL_debug_renderer_info"),r=s?String(n.getParameter(s.UNMASKED_RENDERER_WEBGL)):"";
if(t||/swiftshader|llvmpipe|software|basic render/i.test(r))return{canvas:i,context:n,software:!t};let o=i.cloneNode();return i.replaceWith(o),n.getExtension("WEBGL_lose_context")?.loseContext(),{canvas:o,context:e(o,!0),software:!1}}function A0(i,t){return new ge().compose(new W(...i),new di(t[1],t[2],t[3],t[0]),new W(1,1,1))}function G1(i){let t=i.radius??1,[e,n,s]=i.kind==="sphere"?[t,t,t]:i.kind===
"box"||i.kind==="ellipsoid"?i.halfExtents??[1,1,1]:i.kind==="cylinder"||i.kind==="cone"?[t,t,i.halfLength??1]:i.kind==="circle"?[t,t,.08*t]:[1,1,1];return A0(i.position,i.orientation).scale(new W(e,n,s))}var E0=new W,T0=new di,W1=new W(1,1,1);function X1(i,t,e){E0.set(t[e],t[e+1],t[e+2]),T0.set(t[e+4],t[e+5],t[e+6],t[e+3]),i.compose(E0,T0,W1)}var q1=400,dh=class{constructor(t,e,n,s){this.box=t;this.model=e;this.handler=n;this.camera=new ul;this.space=null;this.show={contacts:!0,trails:!1};this.forceFactor=1;this.selected=-1;this.followed=-1;this.anchor=[0,0,0];this.ratio=0;let r=o=>t.querySelector(`#${o}`);if(this.flat=new fl(r("flat"),e),this.overlay=new dl(r("overlay"),e.film),s!=="0")try{this.space=new fh(r("space"),e,s==="fine")}catch{
console.info("no WebGL: plain canvas")}this.camera.perspective=this.space!==null,this.camera.upAxis=e.upAxis,e.upAxis===1&&(this.camera.azimuth=28*Math.PI/180),this.size=e.extent.size,this.addPointer(this.overlay.canvas)}get spatial(){return this.camera.isPlanar&&this.model.bodies.length<=q1?null:this.space}draw(t){if(this.followed>=0){let{r:n}=this.model.film.pose(this.followed,t);this.camera.centre=
Rt(this.camera.centre,ue(n,this.anchor)),this.anchor=n}let e=this.spatial;this.flat.canvas.hidden=e!==null,this.space&&(this.space.canvas.hidden=e===null),(e??this.flat).draw(this.camera,t,this.selected),this.overlay.draw(this.camera,t,this.size,this.show,this.forceFactor)}setView(t){this.camera.view=t,this.camera.look(),this.fit()}fit(){let t=this.followed>=0?this.model.pointsAround(this.followed,
this.anchor):this.model.extent.points;this.size=this.followed>=0?gm(t):this.model.extent.size,this.camera.fit(t)}follow(t,e){this.followed=t,t>=0&&(this.anchor=this.model.film.pose(t,e).r)}recolour(){this.flat.recolour(),this.space?.recolour()}resize(){let t=Math.min(window.devicePixelRatio||1,2),{clientWidth:e,clientHeight:n}=this.box;if(!e||!n||e===this.camera.width&&n===this.camera.height&&t===
this.ratio)return!1;this.ratio=t;let s=this.camera.width<=1;for(let o of[this.flat,this.space,this.overlay])o?.resize(e,n,t);let r=Math.min(e/this.camera.width,n/this.camera.height);return this.camera.width=e,this.camera.height=n,s||(this.camera.scale*=r),!0}picture(t){this.draw(t);let e=document.createElement("canvas"),n=this.spatial?this.spatial.canvas:this.flat.canvas;e.width=n.width,e.height=n.
height;let s=e.getContext("2d");return s.drawImage(n,0,0),s.drawImage(this.overlay.canvas,0,0,e.width,e.height),e}addPointer(t){let e=new Map,{camera:n}=this,s=0;t.addEventListener("pointerdown",o=>{t.setPointerCapture(o.pointerId),t.classList.add("dragged"),e.set(o.pointerId,[o.offsetX,o.offsetY]),e.size===1&&(s=0)}),t.addEventListener("pointermove",o=>{let a=e.get(o.pointerId);if(!a)return;let[c,
l]=[o.offsetX-a[0],o.offsetY-a[1]],h=[...e].filter(([u])=>u!==o.pointerId).map(([,u])=>u);if(e.set(o.pointerId,[o.offsetX,o.offsetY]),s+=Math.abs(c)+Math.abs(l),h.length){let u=(f,d)=>Math.hypot(f-h[0][0],d-h[0][1])||1;n.zoom(u(o.offsetX,o.offsetY)/u(a[0],a[1]),h[0][0],h[0][1]),n.pan(c/2,l/2)}else n.isPlanar||o.shiftKey||o.buttons>1?n.pan(c,l):n.orbit(c,l);this.handler.redraw()});let r=o=>{let a=e.
size===1;if(e.delete(o.pointerId),t.classList.remove("dragged"),o.type!=="pointerup"||!a||s>5)return;let c=this.spatial,l=c?c.pick(n,o.offsetX,o.offsetY):this.pickFlat(o.offsetX,o.offsetY);this.handler.selected(l)};t.addEventListener("pointerup",r),t.addEventListener("pointercancel",r),t.addEventListener("contextmenu",o=>o.preventDefault()),t.addEventListener("wheel",o=>{o.preventDefault(),n.zoom(
Math.exp(-.0012*o.deltaY),o.offsetX,o.offsetY),this.handler.redraw()},{passive:!1})}pickFlat(t,e){return this.flat.pick(t,e)}};var C0=8;function Ff(i,t,e,n){if(!(i instanceof HTMLCanvasElement))return;let s=window.devicePixelRatio||1,{clientWidth:r,clientHeight:o}=i;i.width=r*s,i.height=o*s;let a=i.getContext("2d");if(!(!a||!r||!(n>e))){a.scale(s,s);for(let c of[!1,!0]){a.fillStyle=(c?bn[3]:bn[2]).colour+(se.dark?"b0":"90");let l=new Set;for(let h of t){if(h.impact!==c)continue;let u=Math.round(C0+(r-2*C0)*(h.t-e)/(n-e));
l.has(u)||(l.add(u),a.fillRect(u,c?0:19,1.4,6))}}}}var Vt=i=>document.getElementById(i),Nf=class{constructor(t,e,n,s,r,o,a){this.data=t;this.scene=e;this.film=n;this.signals=s;this.events=r;this.studio=new Va(this);this.playing=!1;this.queued=!1;this.tab="";this.sizes="";let c=[n.t,...s.map(d=>d.t)].filter(d=>d.length);this.begin=Math.min(...c.map(d=>d[0])),this.end=Math.max(...c.map(d=>d[d.length-1])),this.begin<=this.end||(this.begin=this.end=0),
this.t=this.begin;let l=a.get("theme");Lh(l?l==="dark":matchMedia("(prefers-color-scheme: dark)").matches),document.documentElement.classList.toggle("dark",se.dark),this.model=new hl(e,n),this.stage=new dh(Vt("stage"),this.model,{redraw:()=>this.draw(),selected:d=>this.select(d)},a.get("webgl"));let h=e.follow??-1;this.stage.follow(h<n.poses?h:-1,this.t);let u=d=>{this.pause().seek(d)};this.plots=
new Go(Vt("plots"),cm(s).slice(0,60),this.begin,this.end,u),this.energy=new Go(Vt("energy"),Ud(o),this.begin,this.end,u),this.list=new Ha(Vt("events"),r,u);let f=document.querySelector("main");f.classList.toggle("alone",!s.length&&!t.model.text&&!t.run),f.classList.toggle("unseen",!e.shapes.length&&s.length>0),this.fillPanels(o.size>0),this.addTransport(),this.addTools(),document.addEventListener(
"keydown",d=>this.key(d)),new ResizeObserver(()=>this.resize()).observe(Vt("stage")),new ResizeObserver(()=>this.resize()).observe(Vt("side")),window.addEventListener("hashchange",()=>Th(this,new URLSearchParams(location.hash.slice(1)))),this.stage.resize(),this.setView(this.model.naturalView()),this.resize(),Th(this,a)}seek(t){return this.t=Gn(t,this.begin,this.end),this.draw(),this}play(){if(this.
playing)return;this.t>=this.end&&(this.t=this.begin),this.playing=!0,Vt("play").innerHTML=Cd;let t=performance.now(),e=n=>{if(!this.playing)return;let s=this.t+(n-t)/1e3*Number(Vt("speed").value);t=n,s>this.end&&(Vt("loop").checked&&this.end>this.begin?s=this.begin+(s-this.begin)%(this.end-this.begin):this.pause()),this.seek(s),this.playing&&requestAnimationFrame(e)};requestAnimationFrame(e)}pause(){
return this.playing=!1,Vt("play").innerHTML=Fh,this}toggle(){this.playing?this.pause():this.play()}step(t){if(this.pause(),!this.film.count)return;let e=this.film.indexAt(this.t),n=this.t>this.film.t[e];this.seek(this.film.t[Gn(t<0&&n?e:e+t,0,this.film.count-1)])}jump(t){let e=this.list.from(this.t,t,1e-9*(this.end-this.begin));e&&this.pause().seek(e.t)}faster(t){let e=Vt("speed");e.selectedIndex=
Gn(e.selectedIndex+t,0,Fo.length-1)}draw(){this.queued||(this.queued=!0,requestAnimationFrame(()=>{this.queued=!1,this.drawNow()}))}drawNow(){this.stage.draw(this.t),this.tab==="plots"&&this.plots.draw(this.t),this.tab==="energy"&&this.energy.draw(this.t),this.tab==="events"&&this.list.show(this.t),Vt("scrub").value=String(this.end>this.begin?(this.t-this.begin)/(this.end-this.begin):0);let t=Gn(4-
Math.floor(Math.log10(this.end-this.begin||1)),0,9);Vt("clock").replaceChildren(this.t.toFixed(t),de("small",` / ${this.end.toFixed(t-1)} s`)),this.fillCard()}resize(){let t=["stage","side"].map(n=>`${Vt(n).clientWidth} ${Vt(n).clientHeight}`).join();if(t===this.sizes)return;this.sizes=t;let e=this.stage.resize();this.showTab(this.tab),e&&this.drawNow(),Ff(Vt("marks"),this.events,this.begin,this.end)}setView(t){
this.stage.setView(t in Uh?t:"iso");for(let e of Vt("views").children)e.classList.toggle("on",e.dataset.view===this.stage.camera.view);this.draw()}setSwitch(t,e){this.stage.show[t]=e,Vt("switches").querySelector(`[data-name=${t}]`)?.classList.toggle("on",e),Vt("legend").hidden=!(this.stage.show.contacts&&this.film.contactCount),this.draw()}setFollow(t){let{stage:e}=this,n=this.scene.follow??this.film.
firstMoving();e.follow(t?e.selected>=0?e.selected:n:-1,this.t),e.selected<0&&e.fit(),Vt("switches").querySelector("[data-name=follow]")?.classList.toggle("on",e.followed>=0),this.draw()}setTheme(t){Lh(t),document.documentElement.classList.toggle("dark",t),this.stage.recolour(),this.plots.rebuild(),this.energy.rebuild(),Ff(Vt("marks"),this.events,this.begin,this.end),this.fillLegend(),this.draw()}select(t){
this.stage.selected=this.scene.frames[t]?t:-1;let e=Vt("selected"),n=this.scene.frames[t];if(e.replaceChildren(),n){let s=de("button","\xD7","close");if(s.onclick=()=>this.select(-1),e.append(s,de("b",n.name)),n.place){let r=de("a",n.place);r.onclick=()=>this.showLine(n.place),e.append(r)}e.append(de("table"))}this.fillCard(),this.draw()}fillCard(){let{selected:t}=this.stage,e=Vt("selected");if(e.
hidden=t<0,t<0)return;let n=e.querySelector("table"),s=this.film.pose(t,this.t),{v:r,omega:o}=this.film.rates(t,this.t),a=2*Math.acos(Gn(Math.abs(s.q[0]),0,1))*180/Math.PI,c=[...["x","y","z"].map((h,u)=>[h,`${Bn(s.r[u])} m`]),["speed",`${Bn(Tn(r))} m/s`],["turned by",`${Bn(a)}\xB0`],["turns with",`${Bn(Tn(o))} rad/s`]],l=`${this.scene.frames[t].name.split(".")[0]}.`;for(let h of this.signals.filter(
u=>u.name.startsWith(l)&&!/\.[xyz]$/.test(u.name)).slice(0,8)){let u=h.t.length-1;for(;u>0&&h.t[u]>this.t;)--u;c.push([h.name.slice(l.length),`${Bn(h.y[u])} ${h.unit}`])}n.replaceChildren(...c.map(([h,u])=>{let f=de("tr");return f.append(de("td",h),de("td",u)),f}))}fillPanels(t){let{title:e,run:n,model:s}=this.data,r=n&&typeof n.title=="string"&&n.title?n.title:e;Vt("title").textContent=r,Vt("titl\
e").title=r,document.title=`${r} \xB7 dynamY replay`,Vt("facts").replaceChildren(...Dd(this.data,this.end-this.begin,this.film.count)),n&&Vt("run").append(...[Ld(n),Id(n)].filter(l=>l!==null)),s.text&&Vt("model").append(Fd(s.text)),Vt("theme").innerHTML=Rd,Vt("theme").onclick=()=>this.setTheme(!se.dark),this.fillLegend();let o=Vt("help"),a=de("table");for(let[l,h]of Pd){let u=a.insertRow();u.insertCell().
textContent=l,u.insertCell().textContent=h}o.append(de("h2","Keys"),a),o.onclick=()=>o.close();let c=[["plots","Signals",this.signals.length>0],["energy","Energy, solver",t],["events","Events",this.events.length>0],["run","Run",n!==null],["model","Model",s.text!==""]];for(let[l,h,u]of c){if(!u)continue;let f=de("button",h);f.dataset.tab=l,f.onclick=()=>this.showTab(l),Vt("tabs").append(f),this.tab||
(this.tab=l)}Vt("wait").hidden=!0}fillLegend(){let t=this.events.some(e=>e.to==="spin");Vt("legend").replaceChildren(...bn.slice(1,t?5:4).map(e=>{let n=de("span"),s=de("i");return s.style.background=se.dark?Je(e.colour,.2):e.colour,n.append(s,e.name),n}))}showTab(t){if(Vt("tabs").querySelector(`[data-tab=${t||"none"}]`)){this.tab=t;for(let e of Vt("tabs").children)e.classList.toggle("on",e.dataset.
tab===t);for(let e of["plots","energy","events","run","model"])Vt(e).hidden=e!==t;t==="plots"&&this.plots.resize(),t==="energy"&&this.energy.resize(),t==="events"&&this.list.show(this.t,!0),this.draw()}}showLine(t){this.showTab("model");let e=Vt("model").querySelectorAll("code");e.forEach(s=>s.classList.remove("here"));let n=e[Number((t.match(/:(\d+)/)??[])[1])-1];n&&(n.classList.add("here"),n.scrollIntoView(
{block:"center"}))}addTransport(){let t=this.end-this.begin,e=t>120?t/60:t<4?t/4:1,n=Fo.filter(s=>s<=Math.max(e,Fo[0])*1.05).pop();Vt("speed").replaceChildren(...Fo.map(s=>{let r=de("option",s<1?`1/${Math.round(1/s)}`:`\xD7${s}`);return r.value=String(s),r.selected=s===n,r})),Vt("play").innerHTML=Fh,Vt("play").onclick=()=>this.toggle(),Vt("back").onclick=()=>this.step(-1),Vt("step").onclick=()=>this.
step(1),Vt("before").onclick=()=>this.jump(-1),Vt("after").onclick=()=>this.jump(1);for(let s of["before","after"])Vt(s).disabled=!this.events.length;Vt("scrub").oninput=s=>this.pause().seek(this.begin+Number(s.target.value)*t),Vt("link").onclick=()=>nd(this),Vt("png").onclick=()=>this.savePicture(),Vt("film").onclick=()=>this.saveFilm(),Vt("ask").onclick=()=>this.help()}help(){let t=Vt("help");t.
open?t.close():t.showModal()}savePicture(){let t=de("a");t.href=this.stage.picture(this.t).toDataURL("image/png"),t.download=`${this.data.title}_${this.t.toFixed(3)}s.png`,t.click()}saveFilm(){this.pause(),Ad(this,Number(Vt("speed").value),Vt("film"))}addTools(){let t=(e,n,s,r)=>{let o=de("button",n);return o.title=s,o.onclick=r,Vt(e).append(o),o};for(let e of["xz","xy","yz","iso"])t("views",Uh[e],
"view",()=>this.setView(e)).dataset.view=e;t("views","fit","show everything (0)",()=>{this.stage.fit(),this.draw()});for(let e of this.film.contactCount?["contacts","trails"]:["trails"])t("switches",e,e==="contacts"?"contact forces (c)":"paths of the bodies (t)",()=>this.setSwitch(e,!this.stage.show[e])).dataset.name=e;t("switches","follow","the camera goes with what is selected (f)",()=>this.setFollow(
this.stage.followed<0)).dataset.name="follow",Vt("switches").querySelector("[data-name=follow]")?.classList.toggle("on",this.stage.followed>=0);for(let e of["contacts","trails"])this.setSwitch(e,this.stage.show[e])}key(t){let e=t.target;if(t.ctrlKey||t.altKey||t.metaKey||e.tagName==="SELECT")return;let n=(this.end-this.begin)/10,s=a=>{t.shiftKey?this.pause().seek(this.t+a*n):this.step(a)},r=a=>{this.
stage.forceFactor*=a,this.draw()},o={" ":()=>this.toggle(),ArrowLeft:()=>s(-1),ArrowRight:()=>s(1),Home:()=>this.pause().seek(this.begin),End:()=>this.pause().seek(this.end),n:()=>this.jump(1),p:()=>this.jump(-1),"+":()=>this.faster(1),"-":()=>this.faster(-1),1:()=>this.setView("xz"),2:()=>this.setView("xy"),3:()=>this.setView("yz"),4:()=>this.setView("iso"),0:()=>{this.stage.fit(),this.draw()},c:()=>this.
setSwitch("contacts",!this.stage.show.contacts),t:()=>this.setSwitch("trails",!this.stage.show.trails),f:()=>this.setFollow(this.stage.followed<0),l:()=>Vt("loop").click(),s:()=>this.savePicture(),v:()=>this.saveFilm(),d:()=>this.setTheme(!se.dark),"[":()=>r(.8),"]":()=>r(1.25),"?":()=>this.help(),Escape:()=>{Vt("help").close(),this.select(-1)}};o[t.key]&&(t.preventDefault(),o[t.key]())}};async function Y1(){
let i=JSON.parse(Vt("data").textContent??""),[t,e,n,s,r]=await Promise.all([_d(i),Na.from(i.frames),xd(i),Md(i),bd(i)]),o=new Nf(i,t,e,n,s,r,new URLSearchParams(location.hash.slice(1)));document.body.classList.remove("reading"),Object.assign(window,{replay:o})}Y1().catch(i=>{throw document.body.classList.remove("reading"),Vt("wait").textContent=`This page cannot be shown: ${i instanceof Error?i.message:
i}`,i});})();
