package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.WaypointPosition;
import org.pendant.text.Language;

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
      options.add(new Option(each, taught ? each : text("notTaught", each)));
    }
    return new Item.Choice(
        name,
        label,
        options,
        waypoint,
        false,
        text("isNoWaypointOfThisProgram"),
        each -> set.apply(context.tree(), each));
  }

  /** Choice and buttons. */
  FormBuilder addTo(FormBuilder form) {
    return form.add(choice()).add(buttons());
  }

  /** Sets it, teaches it, goes there. */
  Item.Presses buttons() {
    boolean taught = context.tree().waypoints().containsKey(waypoint);
    String what =
        label.isEmpty() ? text("theWaypoint") : Language.ofProcess().withinSentence(label);
    return new Item.Presses(
        name + "-buttons",
        "",
        List.of(
            FormBuilder.press(
                name + "-here",
                text("setHere"),
                text("putWhereTheToolIsNow", what),
                true,
                this::setHere),
            FormBuilder.press(
                name + "-teach",
                text("teach"),
                text("moveTheArmToWhereShall", what),
                true,
                this::teach),
            new Item.Press(
                name + "-go",
                text("holdToGoThere"),
                text("moveTheArmToForAs", what),
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
    context.change(text("setPlaceHere", chosen), with(chosen).withWaypoint(chosen, here));
  }

  private void teach() {
    String chosen = named();
    if (!chosen.equals(waypoint)) {
      context.change(text("namePlace", chosen), with(chosen));
    }
    context.host().teach(chosen);
  }
}
