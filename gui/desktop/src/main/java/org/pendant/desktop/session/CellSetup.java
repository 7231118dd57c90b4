package org.pendant.desktop.session;

import java.util.List;
import java.util.function.UnaryOperator;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellPlan;

/**
 * Cell setup: how several controllers that share a cell are switched on.
 *
 * @param plan of the cell
 * @param options of each controller, in the order of {@link
 *     org.pendant.controller.layout.CellLayout#names}
 */
public record CellSetup(CellPlan plan, List<ControllerOptions> options) {
  /** The list is copied. */
  public CellSetup {
    options = List.copyOf(options);
  }

  /** The same with each controller switched on otherwise. */
  CellSetup with(UnaryOperator<ControllerOptions> change) {
    return new CellSetup(plan, options.stream().map(change).toList());
  }
}
