package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.PartPool;
import org.pendant.models.time.FrameTime;

/**
 * Source device: puts parts into the cell, as many as it has. One that has no room waits until
 * there is some.
 */
final class SourceDevice implements CellDevice {
  private final DeviceSetup.Source setup;
  private final Optional<PartPool> pool;
  private final Optional<SignalLine> when;
  private final MessageLog log;
  private long frames;
  private boolean high;
  private boolean due;
  private boolean put;

  SourceDevice(
      DeviceSetup.Source setup, Optional<PartPool> pool, SignalLines lines, MessageLog log) {
    this.setup = setup;
    this.pool = pool;
    when = setup.when().map(lines::line);
    this.log = log;
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("source");
  }

  @Override
  public boolean on() {
    return put;
  }

  @Override
  public String described() {
    return text("sourceOf", setup.count(), setup.object());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    if (setup.everyS() > 0 && ++frames % FrameTime.framesFor(setup.everyS()) == 0) {
      due = true;
    }
    if (when.isPresent()) {
      boolean now = when.get().high();
      due |= now && !high;
      high = now;
    }
    put = due && pool.isPresent() && pool.get().put();
    if (put) {
      due = false;
    } else if (due && pool.isPresent() && pool.get().empty()) {
      due = false;
      log.warnOnce(text("sourceEmpty", name(), setup.count()));
    }
  }
}
