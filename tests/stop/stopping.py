"""Programs are started, and stopped by one Ctrl-C after some time of the processor."""

import os
import signal
import subprocess
import threading
import time

STOPPED = 130  # exit status
# The promise is half a second. It is measured as time of the processor. Other programs that share its caches and its
# cores lengthen that too, up to twice; the time of the clock is only bounded loosely.
MOST_CPU = 1.0
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

    def __init__(self, command, after, folder, may_end=False):
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE)
        self.cpu = self.seconds = 0.0
        self.fault = ""
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
        elif process.returncode != STOPPED and not (may_end and process.returncode == 0):
            self.fault = f"ended with status {process.returncode}, expected {STOPPED}: {self.stderr[:600]}"
        elif self.cpu > MOST_CPU:
            self.fault = f"took {self.cpu:.2f} s of the processor to stop; at most {MOST_CPU} s"
