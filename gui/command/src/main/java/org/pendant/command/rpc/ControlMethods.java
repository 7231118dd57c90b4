package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.models.json.Json;
import org.pendant.models.json.Range;

/** Methods by which the world and an operator act: inputs, speed, messages, safety. */
final class ControlMethods {
  private static final Range FRACTION = new Range(0, 1, "");
  private static final long MAX_NUMBER = 1L << 53;

  private ControlMethods() {}

  static void declareIn(MethodTable table) {
    table.add("inputs.set", List.of("values"), ControlMethods::setInputs);
    table.add("speed", List.of("fraction"), ControlMethods::setSpeed);
    table.add(
        "popup.close",
        List.of("number"),
        (robot, params) -> {
          robot.ask(new MessageCommand.AnswerPopup(popup(robot, params)));
          return Map.of();
        });
    table.add("question.answer", List.of("number", "answer"), ControlMethods::answer);
    table.add(
        "question.cancel",
        List.of("number"),
        (robot, params) -> {
          robot.ask(new MessageCommand.CancelQuestion(question(robot, params)));
          return Map.of();
        });
    table.add("safety.set", List.of("values"), ControlMethods::setSafety);
    table.add("safety.do", List.of("action"), ControlMethods::doSafety);
  }

  /**
   * The number of a message: the one that is named, or that of the oldest.
   *
   * @param refusal for where none is open
   */
  private static long number(RpcParams params, Stream<Long> open, String refusal)
      throws RpcFailure {
    OptionalLong named = params.whole("number", 1, MAX_NUMBER);
    return named.isPresent()
        ? named.getAsLong()
        : open.findFirst()
            .orElseThrow(() -> RpcFailure.of(new Refusal(Refusal.Code.UNKNOWN, refusal)));
  }

  private static long popup(DrivenRobot robot, RpcParams params) throws RpcFailure {
    return number(
        params, robot.state().openPopups().stream().map(Popup::number), RpcTexts.text("noPopup"));
  }

  private static long question(DrivenRobot robot, RpcParams params) throws RpcFailure {
    return number(
        params,
        robot.state().openQuestions().stream().map(Question::number),
        RpcTexts.text("noQuestion"));
  }

  private static Map<String, Json.Member> values(RpcParams params) throws RpcFailure {
    Json values = params.get("values").orElseThrow(() -> RpcParams.missing("values"));
    return RpcParams.members("values", values);
  }

  private static Object setInputs(DrivenRobot robot, RpcParams params) throws RpcFailure {
    List<SignalWrite> writes = new ArrayList<>();
    for (var each : values(params).entrySet()) {
      String text =
          InputValue.text(each.getKey(), each.getValue().value(), Optional.of(robot.state()));
      try {
        SignalText.input(each.getKey(), text).stream()
            .filter(write -> !isSoAlready(write, robot.state()))
            .forEach(writes::add);
      } catch (IllegalArgumentException e) {
        throw RpcFailure.params(e.getMessage());
      }
    }
    robot.ask(new IoCommand.WriteSignals(InputOwners.BY_HAND, writes));
    return Map.of();
  }

  /** While a program runs, domains are not changed from outside. */
  private static boolean isSoAlready(SignalWrite write, ControllerState state) {
    return write instanceof SignalWrite.Domain(var bank, int index, var domain)
        && state.signals().analog().signal(bank, index).domain() == domain;
  }

  private static Object setSpeed(DrivenRobot robot, RpcParams params) throws RpcFailure {
    var fraction = params.number("fraction", FRACTION);
    if (fraction.isEmpty()) {
      throw RpcParams.missing("fraction");
    }
    robot.ask(new BoxCommand.SetSpeedFraction(fraction.getAsDouble()));
    return Map.of();
  }

  private static Object answer(DrivenRobot robot, RpcParams params) throws RpcFailure {
    Json answer = params.get("answer").orElseThrow(() -> RpcParams.missing("answer"));
    robot.ask(new MessageCommand.AnswerQuestion(question(robot, params), answer(answer)));
    return Map.of();
  }

  private static Answer answer(Json answer) throws RpcFailure {
    return switch (answer) {
      case Json.Text text -> new Answer.Text(ByteText.asBytes(text.value()));
      case Json.Numeral number when number.value() == (int) number.value() ->
          new Answer.Whole((int) number.value());
      case Json.Numeral number -> new Answer.Decimal(number.value());
      case Json.Word _, Json.Elements _, Json.Members _ ->
          new Answer.Bool(RpcParams.level("answer", answer));
    };
  }

  private static Object setSafety(DrivenRobot robot, RpcParams params) throws RpcFailure {
    for (var each : values(params).entrySet()) {
      boolean active = RpcParams.level(each.getKey(), each.getValue().value());
      try {
        robot.ask(new SafetyCommand.SetSafetyInput(SafetyInput.named(each.getKey()), active));
      } catch (IllegalArgumentException e) {
        throw RpcFailure.params(e.getMessage());
      }
    }
    return Map.of();
  }

  private static Object doSafety(DrivenRobot robot, RpcParams params) throws RpcFailure {
    String action = params.text("action").orElseThrow(() -> RpcParams.missing("action"));
    robot.ask(
        switch (action) {
          case "unlock" -> new SafetyCommand.UnlockProtectiveStop(true);
          case "restart" -> new SafetyCommand.RestartSafety();
          case "power_on" -> new SafetyCommand.PowerOn();
          case "power_off" -> new SafetyCommand.PowerOff();
          case "release_brakes" -> new SafetyCommand.ReleaseBrakes();
          default -> throw RpcFailure.params(text("wrongAction", action));
        });
    return Map.of();
  }
}
