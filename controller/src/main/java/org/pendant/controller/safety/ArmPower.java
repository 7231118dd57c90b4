package org.pendant.controller.safety;

import org.pendant.controller.motion.FrameTime;

/** Power and brakes: each step towards a running arm takes its time, in frames. */
final class ArmPower {
  private static final long BOOTING_FRAMES = FrameTime.framesFor(1.0);
  private static final long POWER_ON_FRAMES = FrameTime.framesFor(0.6);
  private static final long BRAKE_FRAMES = FrameTime.framesFor(1.0);

  private RobotMode mode;
  private long framesInMode;
  private boolean releasing;

  ArmPower(boolean running) {
    mode = running ? RobotMode.RUNNING : RobotMode.POWER_OFF;
  }

  RobotMode mode() {
    return mode;
  }

  boolean running() {
    return mode == RobotMode.RUNNING;
  }

  /** Starts towards IDLE, unless the arm is on or on its way. */
  void on() {
    if (mode == RobotMode.POWER_OFF) {
      enter(RobotMode.BOOTING);
    }
  }

  /** Cuts the power; the brakes close. */
  void off() {
    releasing = false;
    enter(RobotMode.POWER_OFF);
  }

  /** Starts towards RUNNING, from wherever the arm is. */
  void releaseBrakes() {
    if (mode != RobotMode.RUNNING && !releasing) {
      on();
      releasing = true;
      framesInMode = mode == RobotMode.IDLE ? 0 : framesInMode;
    }
  }

  void startBackdrive() {
    releasing = false;
    enter(RobotMode.BACKDRIVE);
  }

  void endBackdrive() {
    enter(RobotMode.IDLE);
  }

  /** A frame passes. */
  void step() {
    framesInMode++;
    switch (mode) {
      case BOOTING -> goOnAfter(BOOTING_FRAMES, RobotMode.POWER_ON);
      case POWER_ON -> goOnAfter(POWER_ON_FRAMES, RobotMode.IDLE);
      case IDLE -> {
        if (releasing) {
          goOnAfter(BRAKE_FRAMES, RobotMode.RUNNING);
        }
      }
      case NO_CONTROLLER,
          DISCONNECTED,
          CONFIRM_SAFETY,
          POWER_OFF,
          BACKDRIVE,
          RUNNING,
          UPDATING_FIRMWARE -> {}
    }
  }

  private void goOnAfter(long frames, RobotMode next) {
    if (framesInMode >= frames) {
      enter(next);
    }
  }

  private void enter(RobotMode next) {
    mode = next;
    framesInMode = 0;
    releasing &= next != RobotMode.RUNNING;
  }
}
