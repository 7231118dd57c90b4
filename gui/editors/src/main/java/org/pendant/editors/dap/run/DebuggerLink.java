package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.Robot;
import org.pendant.script.value.ScriptError;

/** Debugger link: leads to the debugger in the frame loop of a robot. */
final class DebuggerLink {
  private final Robot robot;
  private final Executor answers;

  /**
   * A link.
   *
   * @param answers takes what comes of questions
   */
  DebuggerLink(Robot robot, Executor answers) {
    this.robot = robot;
    this.answers = answers;
  }

  /** {@link DebuggedRobot#ask}. */
  <T> CompletableFuture<T> ask(DebuggedRobot.Question<T> question) {
    CompletableFuture<T> found = new CompletableFuture<>();
    // before it is asked: what comes of it is told later than the answer
    CompletableFuture<T> answer = found.whenCompleteAsync((value, fault) -> {}, answers);
    var _ =
        robot
            .submit(
                new DebugCommand.Debug(
                    debugger -> {
                      try {
                        found.complete(question.of(debugger));
                      } catch (ScriptError | RuntimeException e) {
                        found.completeExceptionally(e);
                      }
                    }))
            .thenAccept(
                reply ->
                    // where it was not even asked
                    found.completeExceptionally(
                        new IllegalArgumentException(reply.complaint().orElse(text("noAnswer")))));
    return answer;
  }
}
