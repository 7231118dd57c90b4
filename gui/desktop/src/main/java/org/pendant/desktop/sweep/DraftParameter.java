package org.pendant.desktop.sweep;

import java.util.stream.Collectors;
import org.pendant.sweep.plan.ParameterRange;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepParameter;
import org.pendant.sweep.plan.TargetText;
import org.pendant.sweep.run.ParameterOffer;

/**
 * Parameter of a plan as people edit it: texts that may be wrong.
 *
 * @param target what it changes
 * @param group what that belongs to, for people
 * @param now what it is without a plan; empty where that is not known
 * @param unit of its numbers; empty for none
 * @param chosen whether the plan varies it
 * @param name of its column
 * @param from the least value
 * @param to the largest value
 * @param steps how many values a grid takes of it
 * @param values a list in place of all these; empty for none
 */
record DraftParameter(
    ParameterTarget target,
    String group,
    String now,
    String unit,
    boolean chosen,
    String name,
    String from,
    String to,
    String steps,
    String values) {
  private static final String STEPS = "5";

  /** One that is offered, and not chosen yet. */
  static DraftParameter of(ParameterOffer offer) {
    return new DraftParameter(
        offer.target(),
        offer.group().title(),
        offer.now(),
        offer.unit(),
        false,
        nameOf(offer.target()),
        offer.from(),
        offer.to(),
        STEPS,
        offer.values());
  }

  /** One of a plan that was read, as far as nobody offers it. */
  static DraftParameter of(SweepParameter read) {
    return new DraftParameter(read.target(), "", "", "", false, read.name(), "", "", STEPS, "")
        .reading(read);
  }

  /** The same with what an offer tells; what people have typed stays. */
  DraftParameter offered(ParameterOffer offer) {
    return new DraftParameter(
        target,
        offer.group().title(),
        offer.now(),
        offer.unit(),
        chosen,
        name,
        from.isEmpty() && values.isEmpty() ? offer.from() : from,
        to.isEmpty() && values.isEmpty() ? offer.to() : to,
        steps,
        values);
  }

  /** The same, as a plan has it. */
  DraftParameter reading(SweepParameter read) {
    return switch (read.range()) {
      case ParameterRange.Between(var least, var most, var count) ->
          new DraftParameter(
              target,
              group,
              now,
              unit,
              true,
              read.name(),
              brief(least),
              brief(most),
              count > 0 ? Integer.toString(count) : STEPS,
              "");
      case ParameterRange.Listed(var listed) ->
          new DraftParameter(
              target,
              group,
              now,
              unit,
              true,
              read.name(),
              from,
              to,
              steps,
              listed.stream().map(ParameterValue::text).collect(Collectors.joining(", ")));
    };
  }

  private static String brief(double number) {
    String text = ParameterValue.of(number).text();
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private static String nameOf(ParameterTarget target) {
    String text = TargetText.of(target);
    return target instanceof ParameterTarget.Variable
        ? text.substring(text.indexOf(' ') + 1)
        : text;
  }

  /** What it changes, for people. */
  String title() {
    return switch (target) {
      case ParameterTarget.Variable _ -> nameOf(target);
      case ParameterTarget.CallArgument(var line, var argument) ->
          SweepTexts.text("argumentInLine", argument, line);
      case ParameterTarget.MoveFactor(var argument) ->
          argument.equals("v")
              ? SweepTexts.text("speedOfAllMoves")
              : SweepTexts.text("accelerationOfAllMoves");
      case ParameterTarget.Slider _ -> SweepTexts.text("speedSlider");
      case ParameterTarget.Load(var component) ->
          component == 0
              ? SweepTexts.text("massAtTheFlange")
              : SweepTexts.text("centreOfGravity", "xyz".charAt(component - 1));
      case ParameterTarget.BasePlace(var axis) -> SweepTexts.text("ofTheBase", axis.word());
      case ParameterTarget.FeaturePlace(var feature, var axis) -> feature + ", " + axis.word();
      case ParameterTarget.ObjectPlace(var object, var axis) -> object + ", " + axis.word();
      case ParameterTarget.InputLevel(var signal) -> SweepTexts.text("fromTheStart", signal);
      case ParameterTarget.InputTime(var signal) -> SweepTexts.text("becomesHigh", signal);
      case ParameterTarget.Seed _ -> SweepTexts.text("seedOfNoiseAndRandomNumbers");
      case ParameterTarget.RobotModel _ -> SweepTexts.text("robotModel");
    };
  }

  DraftParameter withChosen(boolean wanted) {
    return new DraftParameter(target, group, now, unit, wanted, name, from, to, steps, values);
  }

  /** One of its texts changed, and chosen by that. */
  DraftParameter with(Part part, String text) {
    return new DraftParameter(
        target,
        group,
        now,
        unit,
        true,
        part == Part.NAME ? text : name,
        part == Part.FROM ? text : from,
        part == Part.TO ? text : to,
        part == Part.STEPS ? text : steps,
        part == Part.VALUES ? text : values);
  }

  /** What people edit. */
  enum Part {
    NAME,
    FROM,
    TO,
    STEPS,
    VALUES
  }

  String text(Part part) {
    return switch (part) {
      case NAME -> name;
      case FROM -> from;
      case TO -> to;
      case STEPS -> steps;
      case VALUES -> values;
    };
  }
}
