package org.pendant.project.program;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Step code: the URScript that people have typed into a step: expressions, script lines, stubs. */
public final class StepCode {
  private StepCode() {}

  /** All texts of a step that are URScript, in the order of its form. */
  public static List<String> of(Step step) {
    List<String> texts = new ArrayList<>();
    changed(
        step,
        text -> {
          texts.add(text);
          return text;
        });
    return texts;
  }

  /** A step with each of these texts changed. */
  public static Step changed(Step step, UnaryOperator<String> change) {
    return switch (step) {
      case Section section -> section(section, change);
      case MotionStep motion -> motion(motion, change);
      case ActionStep action -> action(action, change);
      case FlowStep flow -> flow(flow, change);
      case TemplateStep template -> template(template, change);
      case ForeignStep.Contributed(String source, String type, var data, var stub) ->
          new ForeignStep.Contributed(source, type, data, all(stub, change));
      case ForeignStep.Unknown unknown -> unknown;
    };
  }

  private static List<String> all(List<String> lines, UnaryOperator<String> change) {
    return lines.stream().map(change).toList();
  }

  private static Section section(Section step, UnaryOperator<String> change) {
    return switch (step) {
      case Section.InitialValues initial ->
          new Section.InitialValues(
              initial.values().stream()
                  .map(
                      each ->
                          new Section.InitialValue(
                              each.variable(), change.apply(each.expression())))
                  .toList());
      case Section.Event(String condition) -> new Section.Event(change.apply(condition));
      case Section.BeforeStart _,
          Section.MainProgram _,
          Section.ThreadSection _,
          Section.SubProgram _ ->
          step;
    };
  }

  private static MotionStep motion(MotionStep step, UnaryOperator<String> change) {
    return switch (step) {
      case MotionStep.Waypoint(
              WaypointTarget.Variable(String expression),
              var timing,
              var blendRadiusM) ->
          new MotionStep.Waypoint(
              new WaypointTarget.Variable(change.apply(expression)), timing, blendRadiusM);
      case MotionStep.Direction(
              String feature,
              double x,
              double y,
              double z,
              String expression,
              var speed,
              var acceleration) ->
          new MotionStep.Direction(feature, x, y, z, change.apply(expression), speed, acceleration);
      case MotionStep.Until(UntilRule.Expression(String condition)) ->
          new MotionStep.Until(new UntilRule.Expression(change.apply(condition)));
      case MotionStep.Move _,
          MotionStep.Waypoint _,
          MotionStep.CircleMove _,
          MotionStep.Until _,
          MotionStep.Home _ ->
          step;
    };
  }

  private static ActionStep action(ActionStep step, UnaryOperator<String> change) {
    return switch (step) {
      case ActionStep.Wait(WaitFor.Expression(String condition)) ->
          new ActionStep.Wait(new WaitFor.Expression(change.apply(condition)));
      case ActionStep.SetAction(Setting.Expression(String signal, String expression)) ->
          new ActionStep.SetAction(new Setting.Expression(signal, change.apply(expression)));
      case ActionStep.Popup(String text, boolean isExpression, var kind, boolean halts)
          when isExpression ->
          new ActionStep.Popup(change.apply(text), true, kind, halts);
      case ActionStep.Assignment(String variable, String expression) ->
          new ActionStep.Assignment(variable, change.apply(expression));
      case ActionStep.ScriptLine(String code) -> new ActionStep.ScriptLine(change.apply(code));
      case ActionStep.ScriptFile(String file, List<String> lines) ->
          new ActionStep.ScriptFile(file, all(lines, change));
      case ActionStep.Wait _,
          ActionStep.SetAction _,
          ActionStep.Popup _,
          ActionStep.Halt _,
          ActionStep.Comment _,
          ActionStep.Folder _,
          ActionStep.OperatorInput _,
          ActionStep.Call _,
          ActionStep.Timer _ ->
          step;
    };
  }

  private static FlowStep flow(FlowStep step, UnaryOperator<String> change) {
    return switch (step) {
      case FlowStep.If(String condition, boolean continuously) ->
          new FlowStep.If(change.apply(condition), continuously);
      case FlowStep.ElseIf(String condition, boolean continuously) ->
          new FlowStep.ElseIf(change.apply(condition), continuously);
      case FlowStep.Loop(LoopRule.Times(String count, String variable)) ->
          new FlowStep.Loop(new LoopRule.Times(change.apply(count), variable));
      case FlowStep.Loop(LoopRule.While(String condition, boolean continuously)) ->
          new FlowStep.Loop(new LoopRule.While(change.apply(condition), continuously));
      case FlowStep.Switch(String expression) -> new FlowStep.Switch(change.apply(expression));
      case FlowStep.Case(String value) -> new FlowStep.Case(change.apply(value));
      case FlowStep.Loop _, FlowStep.Else _, FlowStep.DefaultCase _ -> step;
    };
  }

  private static TemplateStep template(TemplateStep step, UnaryOperator<String> change) {
    return switch (step) {
      case TemplateStep.Seek seek -> new SeekChange(seek).found(change.apply(seek.found()));
      case TemplateStep.Screwdriving screw ->
          new TemplateStep.Screwdriving(
              screw.tool(),
              screw.byForce(),
              screw.value(),
              screw.loosen(),
              screw.start(),
              change.apply(screw.until()),
              screw.timeoutS());
      case TemplateStep.Palletizing _,
          TemplateStep.PatternPoint _,
          TemplateStep.Part _,
          TemplateStep.Force _,
          TemplateStep.ConveyorTracking _ ->
          step;
    };
  }
}
