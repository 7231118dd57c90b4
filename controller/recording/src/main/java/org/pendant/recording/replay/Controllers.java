package org.pendant.recording.replay;

import java.util.List;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.Frames;

/**
 * Controllers of a run: one that is alone, or those of a cell.
 *
 * @param frames lets time pass for all of them
 * @param all in their order
 * @param names what people call them; empty for one that is alone
 */
public record Controllers(Frames frames, List<Controller> all, List<String> names) {
  /** The lists are copied. */
  public Controllers {
    all = List.copyOf(all);
    names = List.copyOf(names);
    if (all.isEmpty() || all.size() != names.size()) {
      throw new IllegalArgumentException(
          "there are " + all.size() + " controllers and " + names.size() + " names");
    }
  }

  /** One that is alone. */
  public static Controllers of(Controller alone) {
    return new Controllers(alone, List.of(alone), List.of(""));
  }

  /** Those of a cell. */
  public static Controllers of(Cell cell) {
    return new Controllers(
        cell,
        cell.members().stream().map(Cell.Member::controller).toList(),
        cell.members().stream().map(Cell.Member::name).toList());
  }

  /** The frame that all of them stand in; any thread, but not while they step. */
  long frame() {
    return all.getFirst().state().frame();
  }

  /** What people are told of one of them. */
  String told(int member, String what) {
    return names.get(member).isEmpty() ? what : names.get(member) + ": " + what;
  }
}
