package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import org.pendant.script.function.Outcome;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.value.ScriptError;

/**
 * Side control: what built-ins in an expression of a debugger may do to the program: nothing.
 *
 * @param frame that of the program
 */
record SideControl(long frame) implements ProgramControl {
  @Override
  public void reachesOutside() throws ScriptError {
    throw new ScriptError("not-while-stopped", text("outsideRefused"));
  }

  @Override
  public boolean mayWait() {
    return false;
  }

  @Override
  public void pause() {}

  @Override
  public void halt() {}

  @Override
  public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
      throws ScriptError {
    throw refused("interpreter_mode");
  }

  @Override
  public void endInterpreter() {}

  @Override
  public void clearInterpreter() throws ScriptError {
    throw refused("clear_interpreter");
  }

  private static ScriptError refused(String function) {
    return new ScriptError("not-while-stopped", text("notInExpression", function));
  }
}
