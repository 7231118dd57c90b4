package org.pendant.editors.dap.look;

import static org.pendant.editors.dap.look.LookTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Live view: a program as it stands now.
 *
 * @param state the snapshot that was published when it stopped
 * @param threads as they stand
 */
public record LiveView(DebuggedRobot run, ControllerState state, List<ThreadSnapshot> threads)
    implements StandingProgram {
  /** Copies the list. */
  public LiveView {
    threads = List.copyOf(threads);
  }

  @Override
  public CompletableFuture<List<Scope>> scopes(int thread, int depth) {
    LiveScope scope = new LiveScope(run, thread, depth);
    return scope
        .locals()
        .thenCombine(
            LiveScope.global(run).globals(),
            (locals, globals) -> {
              List<Scope> all = new ArrayList<>();
              all.add(new Scope(text("locals"), "locals", locals));
              all.add(new Scope(text("globals"), "", globals));
              all.addAll(StandingProgram.ofRobot(run.robot().state()));
              return all;
            });
  }

  @Override
  public CompletableFuture<Shown> evaluate(int thread, int depth, String expression) {
    return new LiveScope(run, thread, depth).evaluate(expression);
  }

  @Override
  public CompletableFuture<Shown> assign(int thread, int depth, String target, String value) {
    return new LiveScope(run, thread, depth).assign(target, value);
  }
}
