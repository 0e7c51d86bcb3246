"""Programs are started, and stopped by one Ctrl-C after some time of the processor."""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import glb_files

STOPPED = 130  # exit status
# The promise is half a second. It is measured as time of the processor. Other programs that share its caches and its
# cores lengthen that too, so a run that takes longer is repeated alone; the time of the clock is only bounded loosely.
MOST_CPU = 0.5
REPEATED = 2
MOST_SECONDS = 30.0


def cpu_time(pid):
    """Seconds that all threads of a process have run for."""
    total = 0
    for thread in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{thread}/schedstat") as file:
            total += int(file.read().split()[0])
    return total / 1e9


class Stop:
    """One run of COMMAND that is interrupted after `after` seconds of the processor: `fault` says what is wrong."""

    def __init__(self, command, after, folder):
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE)
        self.cpu = self.seconds = 0.0
        self.fault, self.is_slow = "", False
        stderr = []
        reader = threading.Thread(target=lambda: stderr.append(process.stderr.read()))
        reader.start()
        spent = 0.0
        patience = time.monotonic() + MOST_SECONDS
        while time.monotonic() < patience:
            if os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None:
                break
            try:
                spent = cpu_time(process.pid)
            except OSError:
                continue  # it has just ended
            if spent >= after:
                break
            time.sleep(0.002)
        begin = time.monotonic()
        os.kill(process.pid, signal.SIGINT)
        timer = threading.Timer(MOST_SECONDS, os.kill, (process.pid, signal.SIGKILL))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        reader.join()
        self.seconds = time.monotonic() - begin
        self.cpu = max(0.0, usage.ru_utime + usage.ru_stime - spent)
        self.status = process.returncode
        self.stderr = stderr[0].decode(errors="replace")
        if process.returncode == -signal.SIGKILL:
            self.fault = f"goes on for more than {MOST_SECONDS:.0f} s after Ctrl-C"
        elif process.returncode != STOPPED:
            self.fault = f"ended with status {process.returncode}, expected {STOPPED}: {self.stderr[:600]}"
        elif self.cpu > MOST_CPU:
            self.is_slow = True
            self.fault = f"took {self.cpu:.2f} s of the processor to stop; at most {MOST_CPU} s"


def stop_all(command, programs):
    """Runs programs (name, text, seconds after which each is stopped), two at once; gives (name, text, Stop) of each."""
    with tempfile.TemporaryDirectory() as folder:
        large_files(Path(folder))

        def stop(item):
            number, (name, text, after) = item
            path = Path(folder) / f"program{number}.rbt"
            path.write_text(text)
            return name, text, after, path, Stop([command, "run", "--quiet", path], after, folder)

        with ThreadPoolExecutor(2) as pool:
            runs = list(pool.map(stop, enumerate(programs)))
        for name, text, after, path, run in runs:
            for _ in range(REPEATED):
                if run.is_slow:
                    run = Stop([command, "run", "--quiet", path], after, folder)
            yield name, text, run


def large_files(folder):
    """What programs read: large.csv, large.glb and large.urdf."""
    (folder / "large.csv").write_text("t [s],q1 [deg]\n" + "0.5,1.5\n" * 500_000)
    (folder / "large.glb").write_bytes(glb_files.file_of(glb_files.sphere(0.03, 150)))
    chain = "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l{i}"/><child link="l{i + 1}"/>'
                    f'<origin xyz="0 0 0.001"/></joint>' for i in range(900))
    (folder / "large.urdf").write_text(f'<robot name="r">{chain}<link name="l900"/><joint name="j" type="revolute">'
                                       '<parent link="l900"/><child link="tip"/><axis xyz="0 0 1"/>'
                                       '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint><link name="tip"/></robot>')
