package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.Connectors;
import org.pendant.models.json.JsonException;
import org.pendant.script.function.Builtins;

/**
 * Switch-on: makes the controllers of a run once more, as they were when it began, for each of the
 * ways that lead through it again. Any thread.
 */
@FunctionalInterface
public interface SwitchOn {
  /**
   * Makes them.
   *
   * @param outside by which each of them reaches other computers, in their order
   */
  Controllers with(List<Connectors> outside);

  /** One that is alone. */
  static SwitchOn of(ControllerOptions options, Builtins<ControlBox> builtins) {
    return outside ->
        Controllers.of(new Controller(options.withOutside(outside.getFirst()), builtins));
  }

  /** Those of a cell that has been switched on by this plan and these options before. */
  static SwitchOn of(
      CellPlan plan, List<ControllerOptions> options, Builtins<ControlBox> builtins) {
    List<ControllerOptions> each = List.copyOf(options);
    return outside -> {
      List<ControllerOptions> own = new ArrayList<>();
      for (int i = 0; i < each.size(); i++) {
        own.add(each.get(i).withOutside(outside.get(i)));
      }
      try {
        return Controllers.of(new Cell(plan, own, builtins));
      } catch (JsonException e) {
        throw new IllegalStateException("the cell cannot be switched on once more", e);
      }
    };
  }
}
