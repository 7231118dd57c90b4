package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.VacuumGripper;
import org.pendant.models.time.FrameTime;

/** Vacuum device: a gripper that sucks. It holds a part when its vacuum has built up. */
final class VacuumDevice implements CellDevice {
  private final DeviceSetup.Vacuum setup;
  private final SignalLine suck;
  private final Optional<VacuumGripper> cup;
  private final MessageLog log;
  private final SensorLine holds;
  private final long fullFrames;
  private long frames;
  private boolean part;
  private boolean held;

  VacuumDevice(
      DeviceSetup.Vacuum setup, SignalLines lines, Optional<VacuumGripper> cup, MessageLog log) {
    this.setup = setup;
    suck = lines.line(setup.suck());
    this.cup = cup;
    this.log = log;
    holds = new SensorLine(lines, setup.holds());
    fullFrames = FrameTime.framesFor(setup.timeS());
    part = setup.part();
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("vacuumGripper");
  }

  @Override
  public boolean on() {
    return held;
  }

  @Override
  public double maxPartWidthM() {
    return 1;
  }

  @Override
  public double partWidthM() {
    return part ? 1 : 0;
  }

  @Override
  public String described() {
    return text("vacuumGripperOf", setup.suck());
  }

  @Override
  public boolean putPart(double widthM) {
    part = widthM > 0;
    return true;
  }

  @Override
  public void step() {
    boolean sucks = suck.high();
    boolean lost = cup.isPresent() && cup.get().losesWhatIsTooMuch();
    boolean there = !lost && (part || ((sucks || frames > 0) && seals()));
    if (there && sucks) {
      frames = Math.min(frames + 1, fullFrames);
    } else {
      // without a part there is no vacuum; a part that is let go comes off as the vacuum goes
      frames = there ? Math.max(frames - 1, 0) : 0;
    }
    boolean now = there && (held ? frames > 0 : sucks && frames >= fullFrames);
    if (now != held) {
      held = now;
      log.info(text(held ? "partHeld" : lost ? "partLost" : "partLetGo", setup.name()));
      work();
    }
    holds.tell(held);
  }

  private boolean seals() {
    return cup.isPresent() && cup.get().seals();
  }

  /** Holds the body at its cup, or lets it go; a part that was put there is no body. */
  private void work() {
    if (cup.isPresent() && held && !part) {
      cup.get().grip();
    } else if (cup.isPresent()) {
      cup.get().release();
    }
  }
}
