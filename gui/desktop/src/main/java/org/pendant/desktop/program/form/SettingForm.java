package org.pendant.desktop.program.form;

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
        new FormBuilder(context, "set", "Set", "Sets an output, the payload or the TCP.");
    form.choice(
        "setting",
        "Set",
        List.of(
            new Option("nothing", "Nothing"),
            new Option("digital", "Digital output"),
            new Option("analog", "Analog output"),
            new Option("pulse", "Pulse on an output"),
            new Option("expression", "Output by expression"),
            new Option("named", "Payload of the installation"),
            new Option("payload", "Payload"),
            new Option("tcp", "TCP"),
            new Option("increment", "Add one to a variable")),
        word(setting),
        "",
        chosen -> step(setting(context, chosen)));
    switch (setting) {
      case Setting.Nothing _ -> form.quiet("nothing", "The program continues at once.");
      case Setting.Digital digital -> digital(form, digital);
      case Setting.Analog analog -> analog(form, analog);
      case Setting.Pulse pulse -> pulse(form, pulse);
      case Setting.Expression expression -> expression(form, expression);
      case Setting.NamedPayload(String name) ->
          form.choice(
              "setting.name",
              "Payload",
              FormContext.options(
                  List.of(), context.installation().payloads(), each -> each.name()),
              name,
              "is no payload of the installation",
              chosen -> step(new Setting.NamedPayload(chosen)));
      case Setting.Payload payload -> payload(form, payload);
      case Setting.Tcp tcp -> tcp(form, tcp);
      case Setting.Increment(String variable) ->
          form.choice(
              "setting.variable",
              "Variable",
              FormContext.options(
                  List.of(), context.installation().variables(), InstallationVariable::name),
              variable,
              "is no variable of the installation",
              chosen -> step(new Setting.Increment(chosen)));
    }
    empty(form, setting);
    return form.build();
  }

  private static void empty(FormBuilder form, Setting setting) {
    boolean payloads = form.context().installation().payloads().isEmpty();
    boolean variables = form.context().installation().variables().isEmpty();
    if (setting instanceof Setting.NamedPayload && payloads) {
      form.quiet("none", "The installation has no payloads yet.");
    } else if (setting instanceof Setting.Increment && variables) {
      form.quiet("none", "The installation has no variables yet.");
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
            "Output",
            form.context().signals().digitalOutputs(),
            digital.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Digital(chosen, digital.level())))
        .either(
            "setting.level",
            "To",
            "High",
            "Low",
            digital.level(),
            level -> step(new Setting.Digital(digital.signal(), level)));
  }

  private static void analog(FormBuilder form, Setting.Analog analog) {
    SignalChoices signals = form.context().signals();
    form.choice(
            "setting.signal",
            "Output",
            signals.analogOutputs(),
            analog.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Analog(chosen, analog.value())))
        .number(
            NodeFields.analogOutput(analog.signal(), form.context().installation().wiring()),
            "To",
            analog.value(),
            signals.range(analog.signal()),
            value -> step(new Setting.Analog(analog.signal(), value)));
  }

  private static void pulse(FormBuilder form, Setting.Pulse pulse) {
    form.choice(
            "setting.signal",
            "Output",
            form.context().signals().digitalOutputs(),
            pulse.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Pulse(chosen, pulse.timeS())))
        .number(
            NodeFields.PULSE_TIME,
            "High for",
            pulse.timeS(),
            time -> step(new Setting.Pulse(pulse.signal(), time)));
  }

  private static void expression(FormBuilder form, Setting.Expression expression) {
    form.choice(
            "setting.signal",
            "Output",
            form.context().signals().outputs(),
            expression.signal(),
            ActionForms.NO_SIGNAL,
            chosen -> step(new Setting.Expression(chosen, expression.expression())))
        .expression(
            "setting.expression",
            "To",
            expression.expression(),
            "such as count > 3",
            text -> step(new Setting.Expression(expression.signal(), text)));
  }

  private static void payload(FormBuilder form, Setting.Payload was) {
    form.number(
        NodeFields.PAYLOAD_MASS,
        "Mass",
        was.massKg(),
        mass -> step(new Setting.Payload(mass, was.cogXM(), was.cogYM(), was.cogZM())));

    form.number(
            NodeFields.PAYLOAD_X,
            "Centre, X",
            was.cogXM(),
            x -> step(new Setting.Payload(was.massKg(), x, was.cogYM(), was.cogZM())))
        .number(
            NodeFields.PAYLOAD_Y,
            "Centre, Y",
            was.cogYM(),
            y -> step(new Setting.Payload(was.massKg(), was.cogXM(), y, was.cogZM())))
        .number(
            NodeFields.PAYLOAD_Z,
            "Centre, Z",
            was.cogZM(),
            z -> step(new Setting.Payload(was.massKg(), was.cogXM(), was.cogYM(), z)));
    form.quiet(
        "payload-hint",
        "All that hangs on the flange, and where its centre of gravity is from there.");
  }

  private static void tcp(FormBuilder form, Setting.Tcp was) {
    List<NamedTool> tools = form.context().installation().tools();
    List<Option> options = new ArrayList<>();
    tools.forEach(each -> options.add(new Option(NAMED + each.name(), each.name())));
    options.add(new Option(OTHER, "Another one, typed below"));
    form.choice(
        "setting.tcp",
        "TCP",
        options,
        was.name().isEmpty() ? OTHER : NAMED + was.name(),
        "is no TCP of the installation",
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
    form.add(new Item.Grid("setting.inFlange", "From the flange", 2, numbers));
  }

  private static Pose poseOf(List<NamedTool> tools, Setting.Tcp tcp) {
    return tools.stream()
        .filter(each -> each.name().equals(tcp.name()))
        .map(NamedTool::inFlange)
        .findFirst()
        .orElse(tcp.inFlange());
  }
}
