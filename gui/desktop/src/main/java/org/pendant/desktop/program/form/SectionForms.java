package org.pendant.desktop.program.form;

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
                  context, "before-start", "Before start", "Runs once, before the main program.")
              .quiet("hint", "Add nodes below it: the palette puts them there.")
              .build();
      case Section.MainProgram main ->
          new FormBuilder(
                  context, "main-program", "Main program", "What the robot does, from the top.")
              .check(
                  "forever",
                  "Begin again at the end, for ever",
                  main.forever(),
                  Section.MainProgram::new)
              .build();
      case Section.ThreadSection thread ->
          new FormBuilder(context, "thread", "Thread", "Runs beside the main program.")
              .text(
                  "name",
                  "Name",
                  thread.name(),
                  "for people, such as Watch gripper",
                  name -> new Section.ThreadSection(name, thread.forever()))
              .check(
                  "forever",
                  "Begin again at the end, for ever",
                  thread.forever(),
                  forever -> new Section.ThreadSection(thread.name(), forever))
              .build();
      case Section.Event event ->
          new FormBuilder(
                  context,
                  "event",
                  "Event",
                  "Runs its nodes once each time when the condition becomes true, beside the main"
                      + " program.")
              .condition(
                  "condition",
                  "Condition",
                  event.condition(),
                  "such as get_standard_digital_in(0)",
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
            "Initial values",
            "Values that variables have before anything else runs.");
    List<String> known = ProgramNames.ownVariables(context.tree());
    List<Section.InitialValue> all = values.values();
    if (all.isEmpty()) {
      form.quiet("none", "No variable has an initial value yet.");
    }
    for (int i = 0; i < all.size(); i++) {
      form.add(row(form, all, i, known));
    }
    return form.presses(
            "add",
            "",
            form.edit(
                "add-value",
                "Add a variable",
                "Add a variable with a value at the start",
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
                "Variable " + (index + 1),
                value.variable(),
                known,
                text -> replaced(all, index, new Section.InitialValue(text, value.expression()))),
            form.expressionOf(
                name + ".expression",
                "Value of variable " + (index + 1),
                value.expression(),
                "value, such as 0",
                text -> replaced(all, index, new Section.InitialValue(value.variable(), text))),
            new Item.Presses(
                name + "-buttons",
                "",
                List.of(
                    form.edit(
                        name + "-remove",
                        "Remove",
                        "Take variable " + (index + 1) + " out of the list",
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
            context, "sub-program", "Sub program", "Nodes that Call nodes run, by its name.");
    form.add(
        new Item.Text(
            "name",
            "Name",
            sub.name(),
            "such as Pick",
            List.of(),
            text -> nameRefusal(context, sub, text.strip()),
            text -> renamed(context, sub, text.strip())));
    long calls = calls(context.tree(), sub.name()).size();
    form.quiet(
        "calls",
        calls == 0
            ? "Nothing calls it yet."
            : calls == 1 ? "One node calls it." : calls + " nodes call it.");
    FileParts.addSubProgram(form, sub);
    return form.build();
  }

  private static String nameRefusal(FormContext context, Section.SubProgram sub, String name) {
    if (name.isEmpty()) {
      return "empty, must be a name";
    }
    return !name.equals(sub.name()) && ProgramNames.subPrograms(context.tree()).contains(name)
        ? "'" + name + "' is another sub program already"
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
