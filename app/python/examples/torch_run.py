"""A run as a function of PyTorch: torch_run.run(model, of, h0=..., e=...) -> tensor of signals.

    h0 = torch.tensor(1.0, dtype=torch.float64, requires_grad=True)
    run("models/bouncing_ball.xml", ["ball.z@0.6"], h0=h0).sum().backward()
"""

import dynamy
import torch


class Run(torch.autograd.Function):
    @staticmethod
    def forward(ctx, model, of, by, *values):
        numbers = {name: float(v) for name, v in zip(by, values)}
        found = dynamy.gradient(model, of=of, by=by, **numbers)
        if found["refused"]:
            raise ValueError(f"no derivative: {found['refused']}")
        ctx.save_for_backward(torch.as_tensor(found["d"].copy()))
        return torch.as_tensor(found["value"].copy())

    @staticmethod
    def backward(ctx, upstream):
        (d,) = ctx.saved_tensors
        return (None, None, None, *(upstream @ d))


def run(model, of, **parameters):
    """Values of the signals `of` ("ball.z@0.6") with these parameters, which may need gradients."""
    return Run.apply(str(model), list(of), list(parameters), *parameters.values())
