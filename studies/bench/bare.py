"""A bare viser app with as many nodes as softrod's page, moving at 60 Hz, for comparison with softrod.

`python -m studies.bench.bare MASSES` serves it and prints its port; `python -m studies.bench.bare MASSES
softrod` serves softrod's page of the same rope instead, and `python -m studies.bench.bare SCENE softrod`
that of a preset. `python -m studies.bench.bare SCENE class PORT` holds a class with a scene, or resumes the
one that is on the disk, and prints its code and its teacher's secret, too. At each line on standard input
it prints the processor time it has used so far; at the end of input, and at SIGTERM, it ends.
"""

from __future__ import annotations

import contextlib
import io
import signal
import sys
import threading
import time
import warnings


def bare(masses: int) -> int:
    """Serve viser alone, with meshes of the same kinds and sizes; returns the port."""
    import numpy as np
    import viser

    warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")
    with contextlib.redirect_stdout(io.StringIO()):
        server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    many = masses > 40
    counts = {"springs": masses - 1, "wedges": (masses - 2) * (1 if many else 6), "masses": 3 * masses}
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    clients: list[list[viser.BatchedMeshHandle]] = []

    @server.on_client_connect
    async def _(client: viser.ClientHandle) -> None:
        clients.append(
            [
                client.scene.add_batched_meshes_simple(
                    f"/body/{name}",
                    corners,
                    np.array([[0, 1, 2]]),
                    np.tile((1.0, 0.0, 0.0, 0.0), (count, 1)),
                    np.zeros((count, 3)),
                    batched_scales=np.ones((count, 3)),
                    batched_colors=np.zeros((count, 3), np.uint8),
                    lod="off",
                    cast_shadow=False,
                    receive_shadow=False,
                )
                for name, count in counts.items()
            ]
        )

    def move() -> None:
        # The same arrays that softrod sends: everything of springs and wedges, the places of masses.
        random = np.random.default_rng(1)
        arrays = {
            name: (
                random.normal(size=(count, 3)).astype(np.float32),
                random.normal(size=(count, 4)).astype(np.float32),
                random.integers(0, 255, (count, 3)).astype(np.uint8),
            )
            for name, count in counts.items()
        }
        due, frame = time.monotonic(), 0
        while True:
            frame += 1
            shift = np.float32(0.001 * (frame % 100))
            for nodes in clients:
                with server.atomic():
                    for node, (name, (places, turns, colors)) in zip(nodes, arrays.items(), strict=True):
                        node.batched_positions = places + shift
                        if name != "masses":
                            node.batched_wxyzs = turns + shift
                            node.batched_scales = places - shift
                            node.batched_colors = colors + np.uint8(frame % 100)
            server.flush()
            due = max(due + 1.0 / 60.0, time.monotonic() - 0.1)
            time.sleep(max(0.0, due - time.monotonic()))

    threading.Thread(target=move, daemon=True).start()
    return server.get_port()


def softrod(shown: str) -> tuple[int, contextlib.ExitStack]:
    """Serve softrod's page of a preset, or of a rope of so many masses; returns the port and what ends it."""
    import sim
    from app.server.serve import serving, start_compiling

    stack = contextlib.ExitStack()
    if shown.isdigit():
        # The joints turn all the time, so that every frame is drawn.
        euler = sim.Integrator(method="symplectic_euler")
        rope = sim.rope(int(shown), length=300.0, force_law="tutorial", integrator=euler)
        scene = sim.set_value(rope, "rest_angle", 4.0)
    else:
        scene = sim.load_scene(shown)
    server, ticker, compiler = stack.enter_context(serving(scene, "127.0.0.1", 0))
    threading.Thread(target=start_compiling, args=(scene, ticker, compiler), daemon=True).start()
    return server.get_port(), stack


def hold_class(shown: str, port: int) -> tuple[str, contextlib.ExitStack]:
    """Hold a class; returns its port, its code and its teacher's secret in one line, and what ends it."""
    import sim
    from app.classroom.live import Classes
    from app.server.serve import serving, start_compiling

    classes = Classes()
    scene = sim.load_scene(shown)
    classes.resume([scene], 1)
    room = next(iter(classes)).room
    stack = contextlib.ExitStack()
    server, ticker, compiler = stack.enter_context(serving(scene, "127.0.0.1", port, classes=classes))
    threading.Thread(target=start_compiling, args=(scene, ticker, compiler), daemon=True).start()
    return f"{server.get_port()} {room.code} {room.key}", stack


def main() -> None:
    """Serve what the command line names."""
    stack = contextlib.ExitStack()
    shown, *kind = sys.argv[1:]
    if kind == ["softrod"]:
        line, stack = softrod(shown)
    elif kind[:1] == ["class"]:
        line, stack = hold_class(shown, int(kind[1]))
    else:
        line = bare(int(shown))
    signal.signal(signal.SIGTERM, lambda *_: sys.exit())
    with stack:
        print(line, flush=True)
        for _ in sys.stdin:
            print(time.process_time(), flush=True)


if __name__ == "__main__":
    main()
