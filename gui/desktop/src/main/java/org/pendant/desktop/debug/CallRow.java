package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.pendant.kit.text.Messages;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Call row: a line of the list of threads and calls.
 *
 * @param depth 1 for the outermost call, 0 for the thread itself
 * @param name of thread or function
 * @param place such as {@code line 12} or {@code node 3 Point}, or what the thread waits for
 */
record CallRow(int thread, int depth, String name, String place) {

  boolean isThread() {
    return depth == 0;
  }

  /**
   * Each thread with its calls below, innermost first.
   *
   * @param places what a line of the running text is called
   */
  static List<CallRow> of(List<ThreadSnapshot> threads, IntFunction<String> places) {
    List<CallRow> rows = new ArrayList<>();
    for (ThreadSnapshot each : threads) {
      String number = each.id() == 0 ? text("mainThread") : text("thread", each.id());
      String waits = each.waitsFor().isEmpty() ? text("ready") : text("waitsIn", each.waitsFor());
      String at = where(each.stack().getFirst(), places);
      rows.add(
          new CallRow(
              each.id(),
              0,
              Messages.told(number, each.name()),
              Messages.joined(List.of(waits, at))));
      int depth = each.stack().size();
      for (ThreadSnapshot.Level level : each.stack()) {
        rows.add(new CallRow(each.id(), depth, level.function(), where(level, places)));
        depth--;
      }
    }
    return rows;
  }

  private static String where(ThreadSnapshot.Level level, IntFunction<String> places) {
    return level.source().equals("interpreter")
        ? text("interpreterLine", level.line())
        : places.apply(level.line());
  }
}
