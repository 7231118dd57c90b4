package org.pendant.controller.safety;

import org.pendant.models.time.FrameTime;

/** Arm power and brakes: each step towards a running arm takes its time, in frames. */
final class ArmPower {
  private final long bootingFrames;
  private final long powerOnFrames;
  private final long brakeFrames;
  private final long offFrames;

  private RobotMode mode;
  private long framesInMode;
  private boolean releasing;

  /** Frames until the power is cut as asked for; 0 when that is not asked for. */
  private long framesToOff;

  private boolean onAfterOff;

  ArmPower(PowerTimes times, boolean running) {
    bootingFrames = FrameTime.framesFor(times.bootS());
    powerOnFrames = FrameTime.framesFor(times.powerOnS());
    brakeFrames = FrameTime.framesFor(times.brakeS());
    offFrames = times.offS() > 0 ? FrameTime.framesFor(times.offS()) : 0;
    mode = running ? RobotMode.RUNNING : RobotMode.POWER_OFF;
  }

  RobotMode mode() {
    return mode;
  }

  boolean running() {
    return mode == RobotMode.RUNNING;
  }

  /** Whether the power is about to be cut. */
  boolean turningOff() {
    return framesToOff > 0;
  }

  /** Starts towards IDLE, unless the arm is on or on its way. */
  void on() {
    if (turningOff()) {
      onAfterOff = true;
    } else if (mode == RobotMode.POWER_OFF) {
      enter(RobotMode.BOOTING);
    }
  }

  /** Cuts the power; the brakes close. */
  void off() {
    releasing = false;
    framesToOff = 0;
    onAfterOff = false;
    enter(RobotMode.POWER_OFF);
  }

  /** Cuts the power after the time that this takes. */
  void turnOff() {
    if (mode == RobotMode.POWER_OFF || offFrames == 0) {
      off();
    } else {
      releasing = false;
      onAfterOff = false;
      framesToOff = turningOff() ? framesToOff : offFrames;
    }
  }

  /** Starts towards RUNNING, from wherever the arm is. */
  void releaseBrakes() {
    if ((mode != RobotMode.RUNNING || turningOff()) && !releasing) {
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
    if (turningOff()) {
      stepOff();
      return;
    }
    switch (mode) {
      case BOOTING -> enterAfter(bootingFrames, RobotMode.POWER_ON);
      case POWER_ON -> enterAfter(powerOnFrames, RobotMode.IDLE);
      case IDLE -> {
        if (releasing) {
          enterAfter(brakeFrames, RobotMode.RUNNING);
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

  private void stepOff() {
    framesToOff--;
    if (framesToOff == 0) {
      boolean again = onAfterOff;
      boolean release = releasing;
      off();
      if (again) {
        on();
        releasing = release;
      }
    }
  }

  private void enterAfter(long frames, RobotMode next) {
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
