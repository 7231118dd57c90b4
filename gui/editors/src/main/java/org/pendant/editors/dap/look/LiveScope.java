package org.pendant.editors.dap.look;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ValueKind;

/**
 * Live scope: a call of a program as it is now, and what can be computed in it.
 *
 * @param thread of the call
 * @param depth of the call, 1 for the outermost
 */
public record LiveScope(DebuggedRobot run, int thread, int depth) {
  /** Begins the name by which data breakpoints know an expression. */
  public static final String WATCHABLE = "value:";

  /** The scope where all global variables can be seen. */
  public static LiveScope global(DebuggedRobot run) {
    return new LiveScope(run, Debugger.MAIN, Debugger.OUTERMOST);
  }

  /** The global variables. */
  public CompletableFuture<Branch> globals() {
    return run.ask(Debugger::globals).thenApply(all -> new Variables(all, this));
  }

  /** The parameters and local variables of the call. */
  public CompletableFuture<Branch> locals() {
    return run.ask(debugger -> debugger.variables(thread, depth))
        .thenApply(all -> new Variables(all, this));
  }

  /** The value of an expression, as people write it. */
  public CompletableFuture<Shown> evaluate(String expression) {
    String bytes = ByteText.asBytes(expression);
    return run.ask(debugger -> debugger.evaluate(thread, depth, bytes)).thenApply(this::shown);
  }

  /** Gives a variable or a part of one a value; what it is then. */
  public CompletableFuture<Shown> assign(String target, String value) {
    String bytes = ByteText.asBytes(target);
    String expression = ByteText.asBytes(value);
    return run.ask(debugger -> debugger.assign(thread, depth, bytes, expression))
        .thenApply(this::shown);
  }

  /** Calls come and go, only global variables can be watched. */
  private Optional<String> watchable(String expression) {
    return thread == Debugger.MAIN && depth == Debugger.OUTERMOST
        ? Optional.of(WATCHABLE + expression)
        : Optional.empty();
  }

  private Shown shown(Variable variable) {
    Optional<Branch> branch =
        variable.children() == 0 ? Optional.empty() : Optional.of(new Parts(variable, this));
    return Shown.of(variable, branch);
  }

  /** The variables of a scope. */
  private record Variables(List<Variable> all, LiveScope scope) implements Branch {
    @Override
    public int size() {
      return all.size();
    }

    @Override
    public boolean indexed() {
      return false;
    }

    @Override
    public CompletableFuture<List<Shown>> page(int start, int count) {
      return CompletableFuture.completedFuture(
          Branch.cut(all, start, count).stream().map(scope::shown).toList());
    }

    @Override
    public CompletableFuture<Shown> assign(String name, String value) {
      return scope.assign(name, value).thenApply(shown -> shown.named(name));
    }

    @Override
    public Optional<String> watchable(String name) {
      return scope.watchable(name);
    }
  }

  /** The elements or members of a value. */
  private record Parts(Variable of, LiveScope scope) implements Branch {
    @Override
    public int size() {
      return of.children();
    }

    @Override
    public boolean indexed() {
      return of.kind().filter(kind -> kind == ValueKind.STRUCT).isEmpty();
    }

    @Override
    public CompletableFuture<List<Shown>> page(int start, int count) {
      return scope
          .run
          .ask(
              debugger ->
                  debugger.children(scope.thread, scope.depth, of.expression(), start, count))
          .thenApply(parts -> parts.stream().map(scope::shown).toList());
    }

    @Override
    public CompletableFuture<Shown> assign(String name, String value) {
      return scope.assign(target(name), value).thenApply(shown -> shown.named(name));
    }

    @Override
    public Optional<String> watchable(String name) {
      return scope.watchable(target(name));
    }

    private String target(String name) {
      return ByteText.decoded(of.expression()) + (name.startsWith("[") ? name : "." + name);
    }
  }
}
