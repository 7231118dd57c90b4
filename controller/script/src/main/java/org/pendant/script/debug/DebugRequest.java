package org.pendant.script.debug;

import java.util.Set;
import java.util.function.Consumer;
import org.pendant.script.value.ScriptError;

/**
 * Debug request: what was asked of a {@link Debugger} and may change where the program stops or
 * what it does, as data: asked again of another debugger at the same point of the same run, it does
 * the same. What only looks is not among them.
 */
public sealed interface DebugRequest extends Consumer<Debugger> {
  /**
   * Asks it once more.
   *
   * @throws IllegalArgumentException where the debugger refuses it, as it did the first time
   */
  @Override
  void accept(Debugger debugger);

  /** {@link Debugger#set}. */
  record SetBreakpoint(Breakpoint breakpoint) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.set(breakpoint);
    }
  }

  /** {@link Debugger#remove}. */
  record RemoveBreakpoint(int line) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.remove(line);
    }
  }

  /** {@link Debugger#removeBreakpoints}. */
  record RemoveBreakpoints() implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.removeBreakpoints();
    }
  }

  /** {@link Debugger#stopOnErrors}. */
  record StopOnErrors(boolean wanted) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.stopOnErrors(wanted);
    }
  }

  /** {@link Debugger#pause}. */
  record Pause() implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.pause();
    }
  }

  /** {@link Debugger#resume}. */
  record Resume() implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.resume();
    }
  }

  /** {@link Debugger#stepInto}. */
  record StepInto(int thread) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.stepInto(thread);
    }
  }

  /** {@link Debugger#stepOver}. */
  record StepOver(int thread) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.stepOver(thread);
    }
  }

  /** {@link Debugger#stepOut}. */
  record StepOut(int thread) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.stepOut(thread);
    }
  }

  /** {@link Debugger#runTo}. */
  record RunTo(int thread, int line) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.runTo(thread, line);
    }
  }

  /** {@link Debugger#stepToCall}. */
  record StepToCall(int thread, Set<String> functions) implements DebugRequest {
    public StepToCall {
      functions = Set.copyOf(functions);
    }

    @Override
    public void accept(Debugger debugger) {
      debugger.stepToCall(thread, functions);
    }
  }

  /** {@link Debugger#kill}. */
  record Kill(int thread) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      debugger.kill(thread);
    }
  }

  /** {@link Debugger#assign}. */
  record Assign(int thread, int depth, String target, String expression) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      try {
        debugger.assign(thread, depth, target, expression);
      } catch (ScriptError e) {
        throw new IllegalArgumentException(e.getMessage(), e);
      }
    }
  }

  /**
   * {@link Debugger#evaluate} or {@link Debugger#children} of an expression with a call: variables
   * stay as they are, but the built-in functions in it have their effects, be it on the next random
   * number only.
   */
  record Evaluate(int thread, int depth, String expression) implements DebugRequest {
    @Override
    public void accept(Debugger debugger) {
      try {
        debugger.evaluate(thread, depth, expression);
      } catch (ScriptError e) {
        throw new IllegalArgumentException(e.getMessage(), e);
      }
    }
  }
}
