package org.pendant.desktop.shell;

import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.script.vm.ThreadSnapshot;

/** Busy notice: tells when a program has not waited for a second, and where it is. */
final class BusyNotice {
  private final Workbench workbench;
  private final DebugPresenter debug;
  private final IntFunction<Optional<RunNode>> nodes;
  private boolean told;

  /**
   * Nothing is told yet.
   *
   * @param nodes the node of a line of the script that runs
   */
  BusyNotice(Workbench workbench, DebugPresenter debug, IntFunction<Optional<RunNode>> nodes) {
    this.workbench = workbench;
    this.debug = debug;
    this.nodes = nodes;
  }

  /** Looks; called with every refresh of the window. */
  void refresh() {
    debug.lookForBusyThreads();
    Optional<ThreadSnapshot> busy = debug.busyThread();
    if (busy.isPresent() && !told) {
      workbench.notify(text(busy.get()), () -> debug.busyThread().isPresent());
    }
    told = busy.isPresent();
  }

  private String text(ThreadSnapshot thread) {
    boolean inText = !thread.stack().getFirst().source().equals("interpreter");
    String place =
        inText
            ? nodes
                .apply(thread.line())
                .map(node -> ShellTexts.text("node", node.number(), node.label()))
                .orElseGet(() -> ShellTexts.text("line", debug.lineNow(thread.line())))
            : ShellTexts.text("aLineOfInterpreterMode");
    return ShellTexts.text("theProgramNeverWaitsSoRobot", place);
  }
}
