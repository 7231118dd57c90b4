package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.NamedTool;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.Setting;

/** Setting form: that of a node that sets something. */
final class SettingForm {
  private static final String OTHER = "other";
  private static final String ANALOG = "analog_out[0]";
  private static final String NAMED = "tcp:";

  private SettingForm() {}

  static NodeForm of(FormContext context, Setting setting) {
    context.kept().keep(setting);
    FormBuilder form =
        new FormBuilder(context, "set", text("set"), text("setsAnOutputThePayloadOr"));
    form.choice(
        "setting",
        text("set"),
        List.of(
            new Option("nothing", text("nothing")),
            new Option("digital", text("digitalOutput")),
            new Option("analog", text("analogOutput")),
            new Option("pulse", text("pulseOnAnOutput")),
            new Option("expression", text("outputByExpression")),
            new Option("named", text("payloadOfTheInstallation")),
            new Option("payload", text("payload")),
            new Option("tcp", "TCP"),
            new Option("increment", text("addOneToAVariable"))),
        word(setting),
        "",
        chosen -> step(setting(context, chosen)));
    switch (setting) {
      case Setting.Nothing _ -> form.quiet("nothing", text("theProgramContinuesAtOnce"));
      case Setting.Digital digital -> digital(form, digital);
      case Setting.Analog analog -> analog(form, analog);
      case Setting.Pulse pulse -> pulse(form, pulse);
      case Setting.Expression expression -> expression(form, expression);
      case Setting.NamedPayload(String name) ->
          form.choice(
              "setting.name",
              text("payload"),
              FormContext.options(
                  List.of(), context.installation().payloads(), each -> each.name()),
              name,
              text("isNoPayloadOfTheInstallation"),
              chosen -> step(new Setting.NamedPayload(chosen)));
      case Setting.Payload payload -> payload(form, payload);
      case Setting.Tcp tcp -> tcp(form, tcp);
      case Setting.Increment(String variable) ->
          form.choice(
              "setting.variable",
              text("variable"),
              FormContext.options(
                  List.of(), context.installation().variables(), InstallationVariable::name),
              variable,
              text("isNoVariableOfTheInstallation"),
              chosen -> step(new Setting.Increment(chosen)));
    }
    empty(form, setting);
    return form.build();
  }

  private static void empty(FormBuilder form, Setting setting) {
    boolean payloads = form.context().installation().payloads().isEmpty();
    boolean variables = form.context().installation().variables().isEmpty();
    if (setting instanceof Setting.NamedPayload && payloads) {
      form.quiet("none", text("theInstallationHasNoPayloadsYet"));
    } else if (setting instanceof Setting.Increment && variables) {
      form.quiet("none", text("theInstallationHasNoVariablesYet"));
    }
  }

  private static ActionStep step(Setting setting) {
    return new ActionStep.SetAction(setting);
  }

  private static String word(Setting setting) {
    return switch (setting) {
      case Setting.Nothing _ -> "nothing";
      case Setting.Digital _ -> "digital";
      case Setting.Analog _ -> "analog";
      case Setting.Pulse _ -> "pulse";
      case Setting.Expression _ -> "expression";
      case Setting.NamedPayload _ -> "named";
      case Setting.Payload _ -> "payload";
      case Setting.Tcp _ -> "tcp";
      case Setting.Increment _ -> "increment";
    };
  }

  private static Setting setting(FormContext context, String chosen) {
    Kept kept = context.kept();
    return switch (chosen) {
      case "digital" ->
          kept.recall(Setting.Digital.class, new Setting.Digital("digital_out[0]", true));
      case "analog" ->
          kept.recall(
              Setting.Analog.class,
              new Setting.Analog(
                  ANALOG,
                  NodeFields.analogOutput(ANALOG, context.installation().wiring()).initialValue()));
      case "pulse" ->
          kept.recall(
              Setting.Pulse.class,
              new Setting.Pulse("digital_out[0]", NodeFields.PULSE_TIME.initialValue()));
      case "expression" ->
          kept.recall(Setting.Expression.class, new Setting.Expression("digital_out[0]", ""));
      case "named" -> kept.recall(Setting.NamedPayload.class, new Setting.NamedPayload(""));
      case "payload" ->
          kept.recall(
              Setting.Payload.class,
              new Setting.Payload(
                  NodeFields.PAYLOAD_MASS.initialValue(),
                  NodeFields.PAYLOAD_X.initialValue(),
                  NodeFields.PAYLOAD_Y.initialValue(),
                  NodeFields.PAYLOAD_Z.initialValue()));
      case "tcp" -> kept.recall(Setting.Tcp.class, new Setting.Tcp("", Pose.ZERO));
      case "increment" -> kept.recall(Setting.Increment.class, new Setting.Increment(""));
      default -> new Setting.Nothing();
    };
  }

  private static void digital(FormBuilder form, Setting.Digital digital) {
    form.choice(
            "setting.signal",
            text("output"),
            form.context().signals().digitalOutputs(),
            digital.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Digital(chosen, digital.level())))
        .either(
            "setting.level",
            text("to"),
            text("high"),
            text("low"),
            digital.level(),
            level -> step(new Setting.Digital(digital.signal(), level)));
  }

  private static void analog(FormBuilder form, Setting.Analog analog) {
    SignalChoices signals = form.context().signals();
    form.choice(
            "setting.signal",
            text("output"),
            signals.analogOutputs(),
            analog.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Analog(chosen, analog.value())))
        .number(
            NodeFields.analogOutput(analog.signal(), form.context().installation().wiring()),
            text("to"),
            analog.value(),
            signals.range(analog.signal()),
            value -> step(new Setting.Analog(analog.signal(), value)));
  }

  private static void pulse(FormBuilder form, Setting.Pulse pulse) {
    form.choice(
            "setting.signal",
            text("output"),
            form.context().signals().digitalOutputs(),
            pulse.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Pulse(chosen, pulse.timeS())))
        .number(
            NodeFields.PULSE_TIME,
            text("highFor"),
            pulse.timeS(),
            time -> step(new Setting.Pulse(pulse.signal(), time)));
  }

  private static void expression(FormBuilder form, Setting.Expression expression) {
    form.choice(
            "setting.signal",
            text("output"),
            form.context().signals().outputs(),
            expression.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Expression(chosen, expression.expression())))
        .expression(
            "setting.expression",
            text("to"),
            expression.expression(),
            text("suchAsCountAboveThree"),
            text -> step(new Setting.Expression(expression.signal(), text)));
  }

  private static void payload(FormBuilder form, Setting.Payload was) {
    form.number(
        NodeFields.PAYLOAD_MASS,
        text("mass"),
        was.massKg(),
        mass -> step(new Setting.Payload(mass, was.cogXM(), was.cogYM(), was.cogZM())));

    form.number(
            NodeFields.PAYLOAD_X,
            text("centreX"),
            was.cogXM(),
            x -> step(new Setting.Payload(was.massKg(), x, was.cogYM(), was.cogZM())))
        .number(
            NodeFields.PAYLOAD_Y,
            text("centreY"),
            was.cogYM(),
            y -> step(new Setting.Payload(was.massKg(), was.cogXM(), y, was.cogZM())))
        .number(
            NodeFields.PAYLOAD_Z,
            text("centreZ"),
            was.cogZM(),
            z -> step(new Setting.Payload(was.massKg(), was.cogXM(), was.cogYM(), z)));
    form.quiet("payload-hint", text("allThatHangsOnTheFlange"));
  }

  private static void tcp(FormBuilder form, Setting.Tcp was) {
    List<NamedTool> tools = form.context().installation().tools();
    List<Option> options = new ArrayList<>();
    tools.forEach(each -> options.add(new Option(NAMED + each.name(), each.name())));
    options.add(new Option(OTHER, text("anotherOneTypedBelow")));
    form.choice(
        "setting.tcp",
        "TCP",
        options,
        was.name().isEmpty() ? OTHER : NAMED + was.name(),
        text("isNoTcpOfTheInstallation"),
        chosen ->
            step(
                chosen.equals(OTHER)
                    ? new Setting.Tcp("", poseOf(tools, was))
                    : new Setting.Tcp(chosen.substring(NAMED.length()), was.inFlange())));
    if (!was.name().isEmpty()) {
      return;
    }
    PoseForm shown = form.context().host().poseForm();
    double[] pose = shown.numbers(was.inFlange());
    List<Item.Quantity> numbers = new ArrayList<>();
    for (int i = 0; i < Pose.SIZE; i++) {
      int changed = i;
      numbers.add(
          form.numberOf(
              NodeFields.tcp(i),
              shown.labels().get(i),
              pose[i],
              value -> {
                double[] typed = pose.clone();
                typed[changed] = value;
                return step(new Setting.Tcp("", shown.pose(typed)));
              }));
    }
    form.add(new Item.Grid("setting.inFlange", text("fromTheFlange"), 2, numbers));
  }

  private static Pose poseOf(List<NamedTool> tools, Setting.Tcp tcp) {
    return tools.stream()
        .filter(each -> each.name().equals(tcp.name()))
        .map(NamedTool::inFlange)
        .findFirst()
        .orElse(tcp.inFlange());
  }
}
