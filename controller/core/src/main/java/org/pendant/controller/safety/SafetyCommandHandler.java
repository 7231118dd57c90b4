package org.pendant.controller.safety;

import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Reply;

/** Handler of the commands to the safety system. */
public final class SafetyCommandHandler implements CommandHandler<SafetyCommand> {
  private final SafetySystem safety;
  private final Runnable stopProgram;

  /**
   * For one safety system.
   *
   * @param stopProgram ends the program, before the arm is powered off
   */
  public SafetyCommandHandler(SafetySystem safety, Runnable stopProgram) {
    this.safety = safety;
    this.stopProgram = stopProgram;
  }

  @Override
  public Class<SafetyCommand> family() {
    return SafetyCommand.class;
  }

  @Override
  public Reply carryOut(SafetyCommand command) {
    return switch (command) {
      case SafetyCommand.PowerOn _ -> Reply.unless(safety.powerOn());
      case SafetyCommand.PowerOff _ -> {
        stopProgram.run();
        safety.powerOff();
        yield Reply.done();
      }
      case SafetyCommand.ReleaseBrakes _ -> Reply.unless(safety.releaseBrakes());
      case SafetyCommand.UnlockProtectiveStop(boolean early) ->
          Reply.unless(safety.unlockProtectiveStop(early));
      case SafetyCommand.RestartSafety _ -> Reply.unless(safety.restartSafety());
      case SafetyCommand.StartBackdrive _ -> Reply.unless(safety.startBackdrive());
      case SafetyCommand.EndBackdrive _ -> Reply.unless(safety.endBackdrive());
      case SafetyCommand.SetManualMode(boolean manual) -> {
        safety.setManualMode(manual);
        yield Reply.done();
      }
      case SafetyCommand.SetSafetyInput(SafetyInput input, boolean active) -> {
        safety.setInput(input, active);
        yield Reply.done();
      }
    };
  }
}
