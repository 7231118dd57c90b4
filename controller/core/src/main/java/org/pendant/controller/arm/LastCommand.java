package org.pendant.controller.arm;

/** Last command: what an arm was asked for in the frame before. */
final class LastCommand {
  private final ArmCommand.Servo target = new ArmCommand.Servo();
  private ArmCommand command = ArmCommand.BRAKES_ON;

  /** The command, as it was then. */
  ArmCommand command() {
    return command;
  }

  /** Whether a command is the same again. */
  boolean is(ArmCommand given) {
    return given instanceof ArmCommand.Servo servo
        ? command == target && target.same(servo)
        : given.equals(command);
  }

  /** Takes a command over; a target may change afterwards. */
  void remember(ArmCommand given) {
    if (given instanceof ArmCommand.Servo servo) {
      target.set(servo);
      command = target;
    } else {
      command = given;
    }
  }
}
