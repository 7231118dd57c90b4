package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.WaitFor;

/**
 * Action forms: those of nodes that do something else than moving; settings have a class of their
 * own.
 */
final class ActionForms {
  static final String NO_SIGNAL = text("isNoSuchSignal");
  private static final String ANALOG = "analog_in[0]";

  private ActionForms() {}

  static NodeForm of(FormContext context, ActionStep step) {
    return switch (step) {
      case ActionStep.Wait wait -> waiting(context, wait.what());
      case ActionStep.SetAction set -> SettingForm.of(context, set.setting());
      case ActionStep.Popup popup -> popup(context, popup);
      case ActionStep.Halt _ ->
          new FormBuilder(context, "halt", text("halt"), text("endsTheProgramAtOnce"))
              .quiet("hint", text("thereIsNothingToSet"))
              .build();
      case ActionStep.Comment comment -> comment(context, comment);
      case ActionStep.Folder folder ->
          new FormBuilder(context, "folder", text("folder"), text("keepsNodesTogetherTheyRunIn"))
              .text("name", text("name"), folder.name(), text("suchAsPick"), ActionStep.Folder::new)
              .build();
      case ActionStep.Assignment assignment -> assignment(context, assignment);
      case ActionStep.OperatorInput input -> operatorInput(context, input);
      case ActionStep.Call call -> call(context, call);
      case ActionStep.ScriptLine line -> scriptLine(context, line);
      case ActionStep.ScriptFile file -> FileParts.scriptFile(context, file);
      case ActionStep.Timer timer -> timer(context, timer);
    };
  }

  private static NodeForm waiting(FormContext context, WaitFor what) {
    context.kept().keep(what);
    FormBuilder form =
        new FormBuilder(context, "wait", text("wait"), text("continuesWhenTheTimeOrSignal"));
    form.sides(
        "what",
        text("waitFor"),
        List.of(
            new Option("nothing", text("nothing")),
            new Option("time", text("time")),
            new Option("digital", text("digital")),
            new Option("analog", text("analog")),
            new Option("expression", text("expression"))),
        switch (what) {
          case WaitFor.Nothing _ -> "nothing";
          case WaitFor.Time _ -> "time";
          case WaitFor.Digital _ -> "digital";
          case WaitFor.Analog _ -> "analog";
          case WaitFor.Expression _ -> "expression";
        },
        chosen -> new ActionStep.Wait(waitFor(context, chosen)));
    SignalChoices signals = context.signals();
    switch (what) {
      case WaitFor.Nothing _ -> form.quiet("nothing", text("theProgramContinuesAtOnce"));
      case WaitFor.Time(double timeS) ->
          form.number(
              NodeFields.WAIT_TIME,
              text("time"),
              timeS,
              value -> new ActionStep.Wait(new WaitFor.Time(value)));
      case WaitFor.Digital(String signal, boolean level) ->
          form.choice(
                  "what.signal",
                  text("signal"),
                  signals.digital(),
                  signal,
                  NO_SIGNAL,
                  value -> new ActionStep.Wait(new WaitFor.Digital(value, level)))
              .either(
                  "what.level",
                  text("toBe"),
                  text("high"),
                  text("low"),
                  level,
                  value -> new ActionStep.Wait(new WaitFor.Digital(signal, value)));
      case WaitFor.Analog(String signal, boolean above, double value) ->
          form.choice(
                  "what.signal",
                  text("signal"),
                  signals.analog(),
                  signal,
                  NO_SIGNAL,
                  chosen -> new ActionStep.Wait(new WaitFor.Analog(chosen, above, value)))
              .either(
                  "what.above",
                  text("toBe"),
                  text("above"),
                  text("below"),
                  above,
                  chosen -> new ActionStep.Wait(new WaitFor.Analog(signal, chosen, value)))
              .number(
                  NodeFields.waitLevel(signal, context.installation().wiring()),
                  text("value"),
                  value,
                  signals.range(signal),
                  chosen -> new ActionStep.Wait(new WaitFor.Analog(signal, above, chosen)));
      case WaitFor.Expression(String condition) ->
          form.condition(
              "what.condition",
              text("condition"),
              condition,
              text("suchAsGetStandardDigitalIn"),
              value -> new ActionStep.Wait(new WaitFor.Expression(value)));
    }
    return form.build();
  }

  private static WaitFor waitFor(FormContext context, String chosen) {
    Kept kept = context.kept();

    return switch (chosen) {
      case "nothing" -> new WaitFor.Nothing();
      case "time" ->
          kept.recall(WaitFor.Time.class, new WaitFor.Time(NodeFields.WAIT_TIME.initialValue()));
      case "digital" ->
          kept.recall(WaitFor.Digital.class, new WaitFor.Digital("digital_in[0]", true));
      case "analog" ->
          kept.recall(
              WaitFor.Analog.class,
              new WaitFor.Analog(
                  ANALOG,
                  true,
                  NodeFields.waitLevel(ANALOG, context.installation().wiring()).initialValue()));
      default -> kept.recall(WaitFor.Expression.class, new WaitFor.Expression(""));
    };
  }

  private static NodeForm popup(FormContext context, ActionStep.Popup popup) {
    FormBuilder form =
        new FormBuilder(context, "popup", text("popup"), text("showsAMessageAndWaitsFor"));
    context.kept().keep(popup.isExpression() ? "expression" : "words", popup.text());
    form.part(text("message"))
        .sides(
            "isExpression",
            text("says"),
            List.of(new Option("words", "A text"), new Option("expression", text("anExpression"))),
            popup.isExpression() ? "expression" : "words",
            chosen ->
                new ActionStep.Popup(
                    context.kept().recall(chosen, String.class).orElse(""),
                    chosen.equals("expression"),
                    popup.kind(),
                    popup.halts()));
    if (popup.isExpression()) {
      form.expression(
          "text",
          text("expression"),
          popup.text(),
          text("suchAsCount"),
          text -> popup(popup, text));
    } else {
      form.add(
          new Item.Prose(
              "text", text("text"), popup.text(), text -> context.with(popup(popup, text))));
    }
    return form.oneOf(
            "kind",
            text("kind"),
            popup.kind(),
            kind ->
                switch (kind) {
                  case MESSAGE -> text("message");
                  case WARNING -> text("warning");
                  case ERROR -> text("error");
                },
            kind -> new ActionStep.Popup(popup.text(), popup.isExpression(), kind, popup.halts()))
        .check(
            "halts",
            text("endTheProgramAfterIt"),
            popup.halts(),
            halts -> new ActionStep.Popup(popup.text(), popup.isExpression(), popup.kind(), halts))
        .part(text("preview"))
        .drawing(
            "preview",
            new Sketch.Message(popup.text(), popup.kind(), popup.halts()),
            text("thePopupAsOperatorsSeeIt"))
        .build();
  }

  private static ActionStep.Popup popup(ActionStep.Popup was, String text) {
    return new ActionStep.Popup(text, was.isExpression(), was.kind(), was.halts());
  }

  private static NodeForm comment(FormContext context, ActionStep.Comment comment) {
    return new FormBuilder(context, "comment", text("comment"), text("aRemarkForPeopleNothingRuns"))
        .add(
            new Item.Prose(
                "text",
                text("text"),
                comment.text(),
                text -> context.with(new ActionStep.Comment(text))))
        .build();
  }

  private static FormBuilder source(FormContext context, String variable, boolean operator) {
    FormBuilder form =
        new FormBuilder(context, "assignment", text("assignment"), text("givesAVariableAValue"));
    return form.add(
        new Item.Choice(
            "source",
            text("valueFrom"),
            List.of(
                new Option("expression", text("expression")),
                new Option("operator", text("operator"))),
            operator ? "operator" : "expression",
            true,
            "",
            chosen -> context.with(assigned(context.kept(), variable, chosen))));
  }

  private static ActionStep assigned(Kept kept, String variable, String chosen) {
    if (chosen.equals("operator")) {
      ActionStep.OperatorInput input =
          kept.recall(
              ActionStep.OperatorInput.class,
              new ActionStep.OperatorInput(variable, ActionStep.InputKind.FLOAT, ""));
      return new ActionStep.OperatorInput(variable, input.kind(), input.message());
    }
    String expression =
        kept.recall(ActionStep.Assignment.class, new ActionStep.Assignment(variable, ""))
            .expression();
    return new ActionStep.Assignment(variable, expression);
  }

  /** Variables that can be given values. */
  private static List<String> assignable(FormContext context) {
    List<String> names = new ArrayList<>(ProgramNames.ownVariables(context.tree()));
    context.installation().variables().stream()
        .map(each -> each.name())
        .filter(each -> !names.contains(each))
        .forEach(names::add);
    return names;
  }

  private static NodeForm assignment(FormContext context, ActionStep.Assignment step) {
    context.kept().keep(step);
    return source(context, step.variable(), false)
        .variable(
            "variable",
            text("variable"),
            step.variable(),
            assignable(context),
            name -> new ActionStep.Assignment(name, step.expression()))
        .expression(
            "expression",
            text("value"),
            step.expression(),
            text("suchAsCountPlusOne"),
            text -> new ActionStep.Assignment(step.variable(), text))
        .build();
  }

  private static NodeForm operatorInput(FormContext context, ActionStep.OperatorInput step) {
    context.kept().keep(step);
    return source(context, step.variable(), true)
        .variable(
            "variable",
            text("variable"),
            step.variable(),
            assignable(context),
            name -> new ActionStep.OperatorInput(name, step.kind(), step.message()))
        .oneOf(
            "kind",
            text("asksFor"),
            step.kind(),
            kind ->
                switch (kind) {
                  case BOOLEAN -> text("yesOrNo");
                  case INTEGER -> text("wholeNumber");
                  case FLOAT -> text("number");
                  case TEXT -> text("text");
                },
            kind -> new ActionStep.OperatorInput(step.variable(), kind, step.message()))
        .add(
            new Item.Prose(
                "message",
                text("question"),
                step.message(),
                text ->
                    context.with(new ActionStep.OperatorInput(step.variable(), step.kind(), text))))
        .build();
  }

  private static NodeForm call(FormContext context, ActionStep.Call call) {
    List<String> subs = ProgramNames.subPrograms(context.tree());
    FormBuilder form =
        new FormBuilder(context, "call", text("call"), text("runsASubProgramThenContinues"))
            .choice(
                "subProgram",
                text("subProgram"),
                FormContext.plain(subs),
                call.subProgram(),
                text("isNoSubProgramOfThis"),
                ActionStep.Call::new);
    if (subs.isEmpty()) {
      form.quiet("none", text("theProgramHasNoSubProgram"));
    }
    context.tree().sections().stream()
        .filter(node -> isSub(node, call.subProgram()))
        .findFirst()
        .ifPresent(
            node ->
                form.presses(
                    "show",
                    "",
                    FormBuilder.press(
                        "show-sub",
                        text("showIt"),
                        text("selectTheSubProgramInThe"),
                        true,
                        () -> context.host().select(node.key()))));
    return form.build();
  }

  private static boolean isSub(ProgramNode node, String name) {
    return node.step() instanceof Section.SubProgram sub && sub.name().equals(name);
  }

  private static NodeForm scriptLine(FormContext context, ActionStep.ScriptLine line) {
    return new FormBuilder(context, "script-line", text("script"), text("urscriptThatRunsAsItIs"))
        .add(
            new Item.Code(
                "code",
                text("code"),
                line.code(),
                true,
                Optional.of(
                    text -> context.with(new ActionStep.ScriptLine(text.replace('\n', ' '))))))
        .build();
  }

  private static NodeForm timer(FormContext context, ActionStep.Timer timer) {
    return new FormBuilder(context, "timer", text("timer"), text("aStopWatchAVariableThat"))
        .variable(
            "name",
            text("timer"),
            timer.name(),
            ProgramNames.timers(context.tree()),
            name -> new ActionStep.Timer(name, timer.action()))
        .oneOf(
            "action",
            text("do"),
            timer.action(),
            action ->
                switch (action) {
                  case START -> text("timerStart");
                  case STOP -> text("timerStop");
                  case RESET -> text("timerReset");
                },
            action -> new ActionStep.Timer(timer.name(), action))
        .build();
  }
}
