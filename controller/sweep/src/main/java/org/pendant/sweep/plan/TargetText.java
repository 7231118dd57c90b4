package org.pendant.sweep.plan;

import static org.pendant.sweep.plan.PlanTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Target text: what parameters change, as plans write it. */
public final class TargetText {
  private static final Pattern VARIABLE = Pattern.compile("([A-Za-z_]\\w*)(?:\\[(\\d{1,4})\\])?");
  private static final Pattern ARGUMENT = Pattern.compile("([1-9]\\d{0,6}) ([A-Za-z_]\\w*)");
  private static final List<String> LOAD = List.of("mass", "cog_x", "cog_y", "cog_z");

  /** What is right, for messages. */
  public static final String LEGAL = text("legalTargets");

  private TargetText() {}

  /** The target that a text means; empty if it means none. */
  public static Optional<ParameterTarget> parse(String text) {
    int blank = text.indexOf(' ');
    String kind = blank < 0 ? text : text.substring(0, blank);
    String rest = blank < 0 ? "" : text.substring(blank + 1).strip();
    return switch (kind) {
      case "variable" -> variable(rest);
      case "argument" -> argument(rest);
      case "speed" -> bare(rest, new ParameterTarget.MoveFactor("v"));
      case "acceleration" -> bare(rest, new ParameterTarget.MoveFactor("a"));
      case "slider" -> bare(rest, new ParameterTarget.Slider());
      case "load" ->
          LOAD.contains(rest)
              ? Optional.of(new ParameterTarget.Load(LOAD.indexOf(rest)))
              : Optional.empty();
      case "base" -> FrameAxis.of(rest).map(ParameterTarget.BasePlace::new);
      case "feature" ->
          lastWord(rest)
              .flatMap(
                  axis ->
                      FrameAxis.of(axis)
                          .map(a -> new ParameterTarget.FeaturePlace(before(rest), a)));
      case "object" ->
          lastWord(rest)
              .flatMap(
                  axis ->
                      FrameAxis.of(axis)
                          .map(a -> new ParameterTarget.ObjectPlace(before(rest), a)));
      case "input" -> input(rest);
      case "seed" -> bare(rest, new ParameterTarget.Seed());
      case "robot" -> bare(rest, new ParameterTarget.RobotModel());
      default -> Optional.empty();
    };
  }

  /** The text that means a target. */
  public static String of(ParameterTarget target) {
    return switch (target) {
      case ParameterTarget.Variable(var name, var element) ->
          "variable " + name + (element.isPresent() ? "[" + element.getAsInt() + "]" : "");
      case ParameterTarget.CallArgument(var line, var argument) ->
          "argument " + line + " " + argument;
      case ParameterTarget.MoveFactor(var argument) ->
          argument.equals("v") ? "speed" : "acceleration";
      case ParameterTarget.Slider _ -> "slider";
      case ParameterTarget.Load(var component) -> "load " + LOAD.get(component);
      case ParameterTarget.BasePlace(var axis) -> "base " + axis.word();
      case ParameterTarget.FeaturePlace(var name, var axis) ->
          "feature " + name + " " + axis.word();
      case ParameterTarget.ObjectPlace(var name, var axis) -> "object " + name + " " + axis.word();
      case ParameterTarget.InputLevel(var signal) -> "input " + signal;
      case ParameterTarget.InputTime(var signal) -> "input " + signal + " time";
      case ParameterTarget.Seed _ -> "seed";
      case ParameterTarget.RobotModel _ -> "robot";
    };
  }

  private static Optional<ParameterTarget> bare(String rest, ParameterTarget target) {
    return rest.isEmpty() ? Optional.of(target) : Optional.empty();
  }

  private static Optional<ParameterTarget> variable(String rest) {
    Matcher matcher = VARIABLE.matcher(rest);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    OptionalInt element =
        matcher.group(2) == null
            ? OptionalInt.empty()
            : OptionalInt.of(Integer.parseInt(matcher.group(2)));
    return Optional.of(new ParameterTarget.Variable(matcher.group(1), element));
  }

  private static Optional<ParameterTarget> argument(String rest) {
    Matcher matcher = ARGUMENT.matcher(rest);
    return matcher.matches()
        ? Optional.of(
            new ParameterTarget.CallArgument(Integer.parseInt(matcher.group(1)), matcher.group(2)))
        : Optional.empty();
  }

  private static Optional<ParameterTarget> input(String rest) {
    if (rest.isEmpty()) {
      return Optional.empty();
    }
    boolean time = lastWord(rest).filter("time"::equals).isPresent();
    return Optional.of(
        time ? new ParameterTarget.InputTime(before(rest)) : new ParameterTarget.InputLevel(rest));
  }

  private static Optional<String> lastWord(String text) {
    int blank = text.lastIndexOf(' ');
    return blank < 0 ? Optional.empty() : Optional.of(text.substring(blank + 1));
  }

  private static String before(String text) {
    return text.substring(0, text.lastIndexOf(' ')).strip();
  }
}
