package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;

/** Section forms: those of the parts of a program. */
final class SectionForms {
  private SectionForms() {}

  static NodeForm of(FormContext context, Section step) {
    return switch (step) {
      case Section.InitialValues values -> initialValues(context, values);
      case Section.BeforeStart _ ->
          new FormBuilder(
                  context,
                  "before-start",
                  text("beforeStart"),
                  text("runsOnceBeforeTheMainProgram"))
              .quiet("hint", text("addNodesBelowItThePalette"))
              .build();
      case Section.MainProgram main ->
          new FormBuilder(
                  context, "main-program", text("mainProgram"), text("whatTheRobotDoesFromThe"))
              .check(
                  "forever",
                  text("beginAgainAtTheEndFor"),
                  main.forever(),
                  Section.MainProgram::new)
              .build();
      case Section.ThreadSection thread ->
          new FormBuilder(context, "thread", text("thread"), text("runsBesideTheMainProgram"))
              .text(
                  "name",
                  text("name"),
                  thread.name(),
                  text("forPeopleSuchAsWatchGripper"),
                  name -> new Section.ThreadSection(name, thread.forever()))
              .check(
                  "forever",
                  text("beginAgainAtTheEndFor"),
                  thread.forever(),
                  forever -> new Section.ThreadSection(thread.name(), forever))
              .build();
      case Section.Event event ->
          new FormBuilder(context, "event", text("event"), text("runsItsNodesOnceEachTime"))
              .condition(
                  "condition",
                  text("condition"),
                  event.condition(),
                  text("suchAsGetStandardDigitalIn"),
                  Section.Event::new)
              .build();
      case Section.SubProgram sub -> subProgram(context, sub);
    };
  }

  private static NodeForm initialValues(FormContext context, Section.InitialValues values) {
    FormBuilder form =
        new FormBuilder(
            context,
            "initial-values",
            text("initialValues"),
            text("valuesThatVariablesHaveBeforeAnything"));
    List<String> known = ProgramNames.ownVariables(context.tree());
    List<Section.InitialValue> all = values.values();
    if (all.isEmpty()) {
      form.quiet("none", text("noVariableHasAnInitialValue"));
    }
    for (int i = 0; i < all.size(); i++) {
      form.add(row(form, all, i, known));
    }
    return form.presses(
            "add",
            "",
            form.edit(
                "add-value",
                text("addAVariable"),
                text("addAVariableWithAValue"),
                with(context, list -> list.add(new Section.InitialValue("", "")))))
        .build();
  }

  private static Item row(
      FormBuilder form, List<Section.InitialValue> all, int index, List<String> known) {
    Section.InitialValue value = all.get(index);
    String name = "values." + index;
    return new Item.Line(
        name,
        "",
        List.of(
            form.variableOf(
                name + ".variable",
                text("variableNumbered", index + 1),
                value.variable(),
                known,
                text -> replaced(all, index, new Section.InitialValue(text, value.expression()))),
            form.expressionOf(
                name + ".expression",
                text("valueOfVariable", index + 1),
                value.expression(),
                text("valueSuchAsZero"),
                text -> replaced(all, index, new Section.InitialValue(value.variable(), text))),
            new Item.Presses(
                name + "-buttons",
                "",
                List.of(
                    form.edit(
                        name + "-remove",
                        text("remove"),
                        text("takeVariableOutOfTheList", index + 1),
                        with(form.context(), list -> list.remove(index)))))));
  }

  private static Section replaced(
      List<Section.InitialValue> all, int index, Section.InitialValue value) {
    List<Section.InitialValue> changed = new ArrayList<>(all);
    changed.set(index, value);
    return new Section.InitialValues(changed);
  }

  /** The program with the list of values changed. */
  private static UnaryOperator<ProgramTree> with(
      FormContext context, Consumer<List<Section.InitialValue>> change) {
    return tree -> {
      List<Section.InitialValue> all = new ArrayList<>();
      Optional<ProgramNode> node = tree.find(context.key());
      if (node.isPresent() && node.get().step() instanceof Section.InitialValues now) {
        all.addAll(now.values());
      }
      change.accept(all);
      return tree.withStep(context.key(), new Section.InitialValues(all));
    };
  }

  private static NodeForm subProgram(FormContext context, Section.SubProgram sub) {
    FormBuilder form =
        new FormBuilder(
            context, "sub-program", text("subProgram"), text("nodesThatCallNodesRunBy"));
    form.add(
        new Item.Text(
            "name",
            text("name"),
            sub.name(),
            text("suchAsPick"),
            List.of(),
            text -> nameRefusal(context, sub, text.strip()),
            text -> renamed(context, sub, text.strip())));
    long calls = calls(context.tree(), sub.name()).size();
    form.quiet(
        "calls",
        calls == 0
            ? text("nothingCallsItYet")
            : calls == 1 ? text("oneNodeCallsIt") : text("nodesCallIt", calls));
    FileParts.addSubProgram(form, sub);
    return form.build();
  }

  private static String nameRefusal(FormContext context, Section.SubProgram sub, String name) {
    if (name.isEmpty()) {
      return text("emptyMustBeAName");
    }
    return !name.equals(sub.name()) && ProgramNames.subPrograms(context.tree()).contains(name)
        ? text("isAnotherSubProgramAlready", name)
        : "";
  }

  private static List<ProgramNode> calls(ProgramTree tree, String name) {
    return tree.nodes().stream()
        .filter(node -> node.step().equals(new ActionStep.Call(name)))
        .toList();
  }

  private static ProgramTree renamed(FormContext context, Section.SubProgram sub, String name) {
    ProgramTree result = context.with(new Section.SubProgram(name, sub.file()));
    if (!sub.name().isEmpty()) {
      for (ProgramNode call : calls(context.tree(), sub.name())) {
        result = result.withStep(call.key(), new ActionStep.Call(name));
      }
    }
    return result;
  }
}
