package org.pendant.gui.debug;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.machine.ThreadSnapshot;

/**
 * A line of the list of threads and calls.
 *
 * @param depth 1 for the outermost call, 0 for the thread itself
 * @param name of thread or function
 * @param place such as {@code line 12}, or what the thread waits for
 */
record CallRow(int thread, int depth, String name, String place) {

  boolean isThread() {
    return depth == 0;
  }

  /** Each thread with its calls below, innermost first. */
  static List<CallRow> of(List<ThreadSnapshot> threads) {
    List<CallRow> rows = new ArrayList<>();
    for (ThreadSnapshot each : threads) {
      String number = each.id() == 0 ? "Main thread" : "Thread " + each.id();
      String waits = each.waitsFor().isEmpty() ? "ready" : "waits in " + each.waitsFor();
      rows.add(new CallRow(each.id(), 0, number + ": " + each.name(), waits));
      int depth = each.stack().size();
      for (ThreadSnapshot.Level level : each.stack()) {
        String where = level.source().equals("interpreter") ? "interpreter, line " : "line ";
        rows.add(new CallRow(each.id(), depth, level.function(), where + level.line()));
        depth--;
      }
    }
    return rows;
  }
}
