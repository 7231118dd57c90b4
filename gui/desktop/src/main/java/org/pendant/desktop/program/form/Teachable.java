package org.pendant.desktop.program.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.WaypointPosition;

/**
 * Teachable place that a node refers to by the name of a waypoint: chosen, set, taught and gone to.
 *
 * @param name of the item
 * @param waypoint the name as it is; empty for none yet
 * @param prefix of a name that is made when it is taught first
 * @param set the program that refers to another name
 */
record Teachable(
    FormContext context,
    String name,
    String label,
    String waypoint,
    String prefix,
    BiFunction<ProgramTree, String, ProgramTree> set) {

  /** A choice of the names there are. */
  Item.Choice choice() {
    List<Option> options = new ArrayList<>();
    for (String each : WaypointNames.of(context.tree())) {
      boolean taught = context.tree().waypoints().containsKey(each);
      options.add(new Option(each, taught ? each : each + " (not taught)"));
    }
    return new Item.Choice(
        name,
        label,
        options,
        waypoint,
        false,
        "is no waypoint of this program",
        each -> set.apply(context.tree(), each));
  }

  /** Choice and buttons. */
  FormBuilder addTo(FormBuilder form) {
    return form.add(choice()).add(buttons());
  }

  /** Sets it, teaches it, goes there. */
  Item.Presses buttons() {
    boolean taught = context.tree().waypoints().containsKey(waypoint);
    String what = label.isEmpty() ? "the waypoint" : label.toLowerCase(Locale.ROOT);
    return new Item.Presses(
        name + "-buttons",
        "",
        List.of(
            FormBuilder.press(
                name + "-here",
                "Set here",
                "Put " + what + " where the tool is now",
                true,
                this::setHere),
            FormBuilder.press(
                name + "-teach",
                "Teach\u2026",
                "Move the arm to where " + what + " shall be",
                true,
                this::teach),
            new Item.Press(
                name + "-go",
                "Hold to go there",
                "Move the arm to " + what + " for as long as this is held",
                taught,
                () -> context.host().holdToGo(waypoint),
                Optional.of(context.host()::release))));
  }

  private String named() {
    return waypoint.isEmpty() ? WaypointNames.free(context.host().tree(), prefix) : waypoint;
  }

  private ProgramTree with(String chosen) {
    ProgramTree now = context.host().tree();
    return chosen.equals(waypoint) ? now : set.apply(now, chosen);
  }

  private void setHere() {
    String chosen = named();
    WaypointPosition here =
        Taught.here(context.host().state(), context.installation(), context.teachFeature());
    context.change("Set " + chosen + " here", with(chosen).withWaypoint(chosen, here));
  }

  private void teach() {
    String chosen = named();
    if (!chosen.equals(waypoint)) {
      context.change("Name " + chosen, with(chosen));
    }
    context.host().teach(chosen);
  }
}
