"""python3 measure.py FOLDER TASK SECONDS: prints the median of the runs in ms, and the result."""

import importlib
import sys
import time

sys.dont_write_bytecode = True
folder, task, seconds = sys.argv[1], sys.argv[2], float(sys.argv[3])
sys.path.insert(0, folder)
run = importlib.import_module(task).run
times = []
while len(times) < 3 or sum(times) < seconds:
    start = time.process_time()
    result = run()
    times.append(time.process_time() - start)
times.sort()
print("%.3f %.6f" % (times[len(times) // 2] * 1000, result))
