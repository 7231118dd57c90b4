package org.pendant.gui.move;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.Command;
import org.pendant.controller.Reply;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Payload;

/** The active TCP and the declared payload: shown, typed and set. */
final class ToolPresenter {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private final Draft tcp;
  private final Draft payload;
  private ArmDescription arm;
  private PoseForm form;
  private String name = "";
  private String tcpReason = "";
  private String payloadReason = "";

  /** Nothing is known yet of the robot; see {@link JogHold} for the arguments. */
  ToolPresenter(
      Function<Command, CompletableFuture<Reply>> submit,
      Executor executor,
      ArmDescription arm,
      PoseForm form) {
    this.submit = submit;
    this.executor = executor;
    this.arm = arm;
    this.form = form;
    tcp = new Draft(form.units(), (index, value) -> Optional.empty());
    payload = new Draft(payloadUnits(form), this::payloadProblem);
  }

  private static List<DisplayUnit> payloadUnits(PoseForm form) {
    return List.of(DisplayUnit.KILOGRAM, form.length(), form.length(), form.length());
  }

  private Optional<String> payloadProblem(int index, double value) {
    return index == 0 && !(value >= 0)
        ? Optional.of("the mass must be at least 0 kg")
        : Optional.empty();
  }

  void setArm(ArmDescription other) {
    arm = other;
    tcp.reset();
    payload.reset();
  }

  void take(ControllerState state) {
    name = state.arm().tool().name();
    tcp.follow(form.numbers(state.arm().tool().inFlange()));
    Payload p = state.readings().payload();
    payload.follow(new double[] {p.massKg(), p.cogXM(), p.cogYM(), p.cogZM()});
  }

  void setForm(PoseForm other) {
    tcp.convert(other.units(), other.numbers(form.pose(tcp.values())));
    payload.convert(payloadUnits(other), payload.values());
    form = other;
  }

  /** The TCP in the flange frame, as {@link PoseForm} shows it. */
  Draft tcp() {
    return tcp;
  }

  /** Mass and the centre of gravity in the flange frame. */
  Draft payload() {
    return payload;
  }

  /** The name of the active TCP; programs give it one. */
  String tcpName() {
    return name;
  }

  /** Makes what was typed the active TCP. */
  void setTcp() {
    if (tcp.edited() && tcp.valid()) {
      var _ =
          submit
              .apply(new Command.SetTool(new ToolCentre(form.pose(tcp.values()), name)))
              .thenAcceptAsync(reply -> tcpReason = settled(reply, tcp), executor);
    }
  }

  /** Declares the payload that was typed. */
  void setPayload() {
    if (payload.edited() && payload.valid()) {
      double[] v = payload.values();
      var _ =
          submit
              .apply(new Command.DeclarePayload(v[0], new Vector3(v[1], v[2], v[3])))
              .thenAcceptAsync(reply -> payloadReason = settled(reply, payload), executor);
    }
  }

  /** What was typed is shown until the controller has it; returns why it does not take it. */
  private static String settled(Reply reply, Draft draft) {
    if (reply instanceof Reply.Refused refused) {
      return refused.reason();
    }
    draft.reset();
    return "";
  }

  void resetTcp() {
    tcpReason = "";
    tcp.reset();
  }

  void resetPayload() {
    payloadReason = "";
    payload.reset();
  }

  /** What is wrong with the TCP that was typed, or why it was refused; empty if nothing. */
  String tcpProblem() {
    return firstOf(tcp, tcpReason);
  }

  /** What is wrong with the payload that was typed, or worth knowing; empty if nothing. */
  String payloadProblem() {
    String problem = firstOf(payload, payloadReason);
    boolean heavy = payload.edited() && payload.values()[0] > arm.payloadKg();
    return problem.isEmpty() && heavy
        ? "More than the " + arm.payloadKg() + " kg that " + arm.displayName() + " is made for"
        : problem;
  }

  private static String firstOf(Draft draft, String otherwise) {
    String problem = draft.problem();
    return problem.isEmpty() && draft.edited() ? otherwise : problem;
  }
}
