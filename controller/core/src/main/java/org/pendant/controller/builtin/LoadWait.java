package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.BackgroundTask;
import org.pendant.motion.toolpath.nc.NcPath;
import org.pendant.script.function.Wait;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Wait of a script thread for a large toolpath file. */
final class LoadWait implements Wait {
  private static final String FUNCTION = "mc_load_path";

  private final ControlBox box;
  private final BackgroundTask<NcPath> reading;
  private final boolean feeds;

  LoadWait(ControlBox box, BackgroundTask<NcPath> reading, boolean feeds) {
    box.clock().determinism().loseInRealTime(text("waitedForToolpath"));
    this.box = box;
    this.reading = reading;
    this.feeds = feeds;
  }

  @Override
  public Optional<Value> poll(long frame) throws ScriptError {
    if (!reading.over()) {
      return Optional.empty();
    }
    try {
      return Optional.of(Value.of(keep(box, reading.result(), feeds)));
    } catch (PlanningException e) {
      throw Planning.failure(FUNCTION, e.failure());
    }
  }

  /** Keeps a file that has been read, and says what of it has no effect. */
  static int keep(ControlBox box, NcPath path, boolean feeds) throws PlanningException {
    int id = box.planning().toolpaths().keep(path, feeds);
    box.clock().determinism().read(path.file(), path.hashCode());
    if (!path.ignored().isEmpty()) {
      box.log().info(text("codesWithoutEffect", path.file(), String.join(", ", path.ignored())));
    }
    return id;
  }
}
