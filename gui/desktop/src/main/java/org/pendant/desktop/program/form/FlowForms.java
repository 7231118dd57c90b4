package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.List;
import java.util.function.Predicate;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Step;

/** Flow forms: those of nodes that decide which nodes run. */
final class FlowForms {
  private static final String CONDITION = text("suchAsGetStandardDigitalIn");

  private FlowForms() {}

  static NodeForm of(FormContext context, FlowStep step) {
    return switch (step) {
      case FlowStep.If when -> when(context, when);
      case FlowStep.ElseIf other -> otherwise(context, other);
      case FlowStep.Else _ ->
          new FormBuilder(context, "else", text("else"), text("runsIfNothingBeforeDid"))
              .quiet("hint", text("thereIsNothingToSet"))
              .build();
      case FlowStep.Loop(LoopRule rule) -> loop(context, rule);
      case FlowStep.Switch(String expression) -> choose(context, expression);
      case FlowStep.Case(String value) ->
          new FormBuilder(context, "case", text("case"), text("runsItsNodesIfTheSwitch"))
              .add(
                  new Item.Text(
                      "value",
                      text("value"),
                      value,
                      text("aNumberSuchAsOne"),
                      List.of(),
                      FlowForms::noNumber,
                      text -> context.with(new FlowStep.Case(text.strip()))))
              .build();
      case FlowStep.DefaultCase _ ->
          new FormBuilder(context, "default-case", text("default"), text("runsItsNodesIfNoCase"))
              .quiet("hint", text("thereIsNothingToSet"))
              .build();
    };
  }

  private static String noNumber(String text) {
    if (text.isBlank()) {
      return "";
    }
    return new FlowStep.Case(text).number().isPresent() ? "" : text("isNotANumber", text.strip());
  }

  private static NodeForm when(FormContext context, FlowStep.If when) {
    FormBuilder form =
        new FormBuilder(context, "if", text("if"), text("runsItsNodesIfTheCondition"))
            .condition(
                "condition",
                text("condition"),
                when.condition(),
                CONDITION,
                text -> new FlowStep.If(text, when.continuously()))
            .check(
                "continuously",
                text("checkContinuously"),
                when.continuously(),
                value -> new FlowStep.If(when.condition(), value));
    continuously(form, when.continuously());
    return branches(form).build();
  }

  private static NodeForm otherwise(FormContext context, FlowStep.ElseIf other) {
    FormBuilder form =
        new FormBuilder(context, "else-if", text("elseIf"), text("runsIfNothingBeforeDidAndTrue"))
            .condition(
                "condition",
                text("condition"),
                other.condition(),
                CONDITION,
                text -> new FlowStep.ElseIf(text, other.continuously()))
            .check(
                "continuously",
                text("checkContinuously"),
                other.continuously(),
                value -> new FlowStep.ElseIf(other.condition(), value));
    continuously(form, other.continuously());
    return branches(form).build();
  }

  private static void continuously(FormBuilder form, boolean on) {
    form.quiet(
        "continuously-hint",
        on ? text("theNodesBelowEndAsSoon") : text("theConditionIsLookedAtOnce"));
  }

  /** Buttons for more branches behind this one. */
  private static FormBuilder branches(FormBuilder form) {
    FormContext context = form.context();
    return form.presses(
        "branches",
        "",
        form.edit(
            "add-else-if",
            text("addElseIf"),
            text("addABranchWithAnotherCondition"),
            tree -> behind(tree, context.key(), new FlowStep.ElseIf(""))),
        FormBuilder.press(
            "add-else",
            text("addElse"),
            text("addABranchForWhenNo"),
            !hasElse(context),
            () -> context.change(text("addElse"), atEnd(context.host().tree(), context.key()))));
  }

  private static int place(ProgramTree tree, long key) {
    List<ProgramNode> beside = beside(tree, key);
    for (int i = 0; i < beside.size(); i++) {
      if (beside.get(i).key() == key) {
        return i;
      }
    }
    return beside.size() - 1;
  }

  private static List<ProgramNode> beside(ProgramTree tree, long key) {
    return tree.parentOf(key).map(tree::childrenOf).orElse(List.of());
  }

  private static ProgramTree behind(ProgramTree tree, long key, Step step) {
    return tree.parentOf(key)
        .map(parent -> tree.insert(parent, place(tree, key) + 1, List.of(ProgramTree.node(step))))
        .orElse(tree);
  }

  /** Where the branches that belong together with a node end. */
  private static int end(ProgramTree tree, long key) {
    List<ProgramNode> beside = beside(tree, key);
    int end = place(tree, key) + 1;
    while (end < beside.size() && beside.get(end).step() instanceof FlowStep.ElseIf) {
      end++;
    }
    return end;
  }

  private static boolean hasElse(FormContext context) {
    List<ProgramNode> beside = beside(context.tree(), context.key());
    int end = end(context.tree(), context.key());
    return end < beside.size() && beside.get(end).step() instanceof FlowStep.Else;
  }

  private static ProgramTree atEnd(ProgramTree tree, long key) {
    return tree.parentOf(key)
        .map(
            parent ->
                tree.insert(parent, end(tree, key), List.of(ProgramTree.node(new FlowStep.Else()))))
        .orElse(tree);
  }

  private static NodeForm loop(FormContext context, LoopRule rule) {
    Kept kept = context.kept();
    kept.keep(rule);
    FormBuilder form =
        new FormBuilder(context, "loop", text("loop"), text("runsItsNodesAgainAndAgain"))
            .sides(
                "rule",
                text("repeats"),
                List.of(
                    new Option("forever", text("forEver")),
                    new Option("times", text("aNumberOfTimes")),
                    new Option("while", text("while"))),
                switch (rule) {
                  case LoopRule.Forever _ -> "forever";
                  case LoopRule.Times _ -> "times";
                  case LoopRule.While _ -> "while";
                },
                chosen ->
                    new FlowStep.Loop(
                        switch (chosen) {
                          case "forever" -> new LoopRule.Forever();
                          case "times" ->
                              kept.recall(LoopRule.Times.class, new LoopRule.Times("2", ""));
                          default ->
                              kept.recall(LoopRule.While.class, new LoopRule.While("", false));
                        }));
    switch (rule) {
      case LoopRule.Forever _ -> {}
      case LoopRule.Times(String count, String variable) ->
          form.expression(
                  "rule.count",
                  text("howOften"),
                  count,
                  text("suchAsFive"),
                  text -> new FlowStep.Loop(new LoopRule.Times(text, variable)))
              .add(
                  new Item.Text(
                      "rule.variable",
                      text("counter"),
                      variable,
                      text("byItself"),
                      ProgramNames.ownVariables(context.tree()),
                      FormBuilder::nameRefusal,
                      text ->
                          context.with(new FlowStep.Loop(new LoopRule.Times(count, text.strip())))))
              .quiet("counter-hint", text("theCounterBeginsAt0Without"));
      case LoopRule.While(String condition, boolean continuously) -> {
        form.condition(
                "rule.condition",
                text("condition"),
                condition,
                text("suchAsCountBelowTen"),
                text -> new FlowStep.Loop(new LoopRule.While(text, continuously)))
            .check(
                "rule.continuously",
                text("checkContinuously"),
                continuously,
                value -> new FlowStep.Loop(new LoopRule.While(condition, value)));
        continuously(form, continuously);
      }
    }
    return form.build();
  }

  private static NodeForm choose(FormContext context, String expression) {
    Predicate<ProgramNode> isDefault = child -> child.step() instanceof FlowStep.DefaultCase;
    boolean whole = context.node().children().stream().anyMatch(isDefault);
    FormBuilder form =
        new FormBuilder(context, "switch", text("switch"), text("runsTheCaseBelowItThat"));
    return form.expression(
            "expression", text("value"), expression, text("suchAsPartKind"), FlowStep.Switch::new)
        .presses(
            "cases",
            "",
            form.edit(
                "add-case",
                text("addCase"),
                text("addACaseBeforeTheDefault"),
                tree -> withCase(tree, context.key(), isDefault)),
            FormBuilder.press(
                "add-default",
                text("addDefault"),
                text("addWhatRunsIfNoCase"),
                !whole,
                () -> {
                  ProgramTree tree = context.host().tree();
                  int end = tree.childrenOf(context.key()).size();
                  context.change(
                      text("addDefault"),
                      within(tree, context.key(), end, new FlowStep.DefaultCase()));
                }))
        .build();
  }

  private static ProgramTree withCase(
      ProgramTree tree, long key, Predicate<ProgramNode> isDefault) {
    List<ProgramNode> cases = tree.childrenOf(key);
    int place = (int) cases.stream().takeWhile(isDefault.negate()).count();
    return within(tree, key, place, new FlowStep.Case(""));
  }

  /** The tree with a node more, or as it is where that would be too deep. */
  private static ProgramTree within(ProgramTree tree, long parent, int index, Step step) {
    List<ProgramNode> added = List.of(ProgramTree.node(step));
    return tree.whyTooDeep(parent, added).isPresent() ? tree : tree.insert(parent, index, added);
  }
}
