package org.pendant.controller.box;

import java.util.List;
import org.pendant.controller.layout.SignalWire;
import org.pendant.controller.rule.RuleSetup;
import org.pendant.controller.rule.RuleSetup.Action;

/**
 * Equipment plan: what in a cell answers the programs of its controllers.
 *
 * @param controllers by their names; none where there is one alone
 * @param devices those of each controller, without rules
 * @param rules of the cell, which may join controllers
 * @param wires between signals of controllers
 */
public record EquipmentPlan(
    List<String> controllers,
    List<CellEquipment> devices,
    List<RuleSetup> rules,
    List<SignalWire> wires) {
  /** Nothing for one controller alone. */
  public static final EquipmentPlan NONE =
      new EquipmentPlan(List.of(), List.of(CellEquipment.NONE), List.of(), List.of());

  /** The lists are copied. */
  public EquipmentPlan {
    controllers = List.copyOf(controllers);
    devices = List.copyOf(devices);
    rules = List.copyOf(rules);
    wires = List.copyOf(wires);
  }

  /** What there is for the first controller without the others. */
  public CellEquipment ofFirst() {
    CellEquipment first = devices.getFirst();
    return new CellEquipment(
        first.devices(), rules.stream().filter(rule -> acts(rule, first)).toList(), controllers);
  }

  private static boolean acts(RuleSetup rule, CellEquipment first) {
    return switch (rule.action()) {
      case Action.Set _ -> true;
      case Action.PutPart put -> has(first, put.gripper());
      case Action.Press press -> has(first, press.device());
    };
  }

  private static boolean has(CellEquipment equipment, String device) {
    return equipment.devices().stream().anyMatch(each -> each.name().equals(device));
  }
}
