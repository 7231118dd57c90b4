package org.pendant.desktop.plot;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.FrameListener;
import org.pendant.script.variables.VariablePath;

/**
 * Variable trace: lets the controller read the variables that are drawn in every frame, also one
 * that is switched on later. The dispatch thread says which; the frame loop looks whether they are
 * there.
 */
final class VariableTrace implements FrameListener {
  private static final String OWNER = "plots";

  /** Frames between two looks. */
  private static final int PERIOD = 50;

  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor display;
  private final Consumer<String> refused;
  private volatile List<String> wanted = List.of();
  private volatile boolean full;

  /**
   * Nothing is drawn yet.
   *
   * @param submit leaves a command for the next frame
   * @param display where refusals are told
   * @param refused is told why variables cannot be read
   */
  VariableTrace(
      Function<Command, CompletableFuture<Reply>> submit,
      Executor display,
      Consumer<String> refused) {
    this.submit = submit;
    this.display = display;
    this.refused = refused;
  }

  /** Has these read in place of all others. */
  void want(Collection<String> paths) {
    List<String> now = List.copyOf(paths);
    if (!now.equals(wanted)) {
      wanted = now;
      full = false;
      ask();
    }
  }

  private void ask() {
    List<VariablePath> paths = wanted.stream().map(VariablePath::of).toList();
    var _ =
        submit
            .apply(new DebugCommand.TraceVariables(OWNER, paths))
            .thenAccept(
                reply -> {
                  Optional<String> why = reply.complaint();
                  if (why.isPresent()) {
                    full = true;
                    display.execute(() -> refused.accept(why.get()));
                  }
                });
  }

  @Override
  public void frame(ControllerState state) {
    if (state.frame() % PERIOD == 0 && !full && missing(state)) {
      ask();
    }
  }

  private boolean missing(ControllerState state) {
    for (String each : wanted) {
      if (!state.traced().has(each)) {
        return true;
      }
    }
    return false;
  }
}
