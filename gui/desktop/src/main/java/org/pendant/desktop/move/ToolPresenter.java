package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Payload;

/** Tool presenter: the active TCP and the declared payload: shown, typed and set. */
final class ToolPresenter {
  /** Number of the first element of the inertia among those of the payload. */
  static final int INERTIA = 4;

  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private final Draft tcp;
  private final Draft payload;
  private final NamedTools named;
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
      PoseForm form,
      NamedTools named) {
    this.submit = submit;
    this.executor = executor;
    this.arm = arm;
    this.form = form;
    this.named = named;
    tcp = new Draft(form.units(), (index, value) -> Optional.empty());
    payload = new Draft(payloadUnits(form), this::payloadProblem);
  }

  private static List<DisplayUnit> payloadUnits(PoseForm form) {
    DisplayUnit inertia = DisplayUnit.KILOGRAM_SQUARE_METRE;
    return List.of(
        DisplayUnit.KILOGRAM,
        form.length(),
        form.length(),
        form.length(),
        inertia,
        inertia,
        inertia,
        inertia,
        inertia,
        inertia);
  }

  private Optional<String> payloadProblem(int index, double value) {
    if (index == 0 && !(value >= 0)) {
      return Optional.of(text("massNegative"));
    }
    return index >= INERTIA && index < INERTIA + 3 && !(value >= 0)
        ? Optional.of(text("inertiaNegative"))
        : Optional.empty();
  }

  void setArm(ArmDescription other) {
    arm = other;
    tcp.reset();
    payload.reset();
  }

  void take(ControllerState state) {
    name = ByteText.decoded(state.arm().tool().name());
    tcp.follow(form.numbers(state.arm().tool().inFlange()));
    Payload p = state.readings().payload();
    payload.follow(
        new double[] {
          p.massKg(),
          p.cogXM(),
          p.cogYM(),
          p.cogZM(),
          p.ixx(),
          p.iyy(),
          p.izz(),
          p.ixy(),
          p.ixz(),
          p.iyz()
        });
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

  /**
   * Mass, the centre of gravity in the flange frame, and the inertia about it: Ixx, Iyy, Izz, Ixy,
   * Ixz, Iyz.
   */
  Draft payload() {
    return payload;
  }

  /** The name of the active TCP; programs give it one. */
  String tcpName() {
    return name;
  }

  /** The TCPs that are kept by name. */
  NamedTools named() {
    return named;
  }

  /** Shows one that is kept, to be made the active one. */
  void choose(String wanted) {
    tcpReason = "";
    named.find(wanted).ifPresent(inFlange -> tcp.put(form.numbers(inFlange)));
  }

  /** Keeps the TCP that is shown under a name; answers why not, empty if it does. */
  String keep(String wanted) {
    String problem = Messages.shown(tcp.valid() ? NamedTools.problem(wanted) : tcp.problem());
    if (problem.isEmpty()) {
      named.keep(wanted, form.pose(tcp.values()));
    }
    return problem;
  }

  /**
   * Makes what was typed the active TCP.
   *
   * @param wanted what it is called; may be empty
   */
  void setTcp(String wanted) {
    if (tcp.valid()) {
      ToolCentre centre = new ToolCentre(form.pose(tcp.values()), ByteText.asBytes(wanted));
      var _ =
          submit
              .apply(new ManualCommand.SetTool(centre))
              .thenAcceptAsync(reply -> tcpReason = settled(reply, tcp), executor);
    }
  }

  /** Declares the payload that was typed. */
  void setPayload() {
    if (payload.edited() && payload.valid()) {
      double[] v = payload.values();
      var _ =
          submit
              .apply(
                  new ManualCommand.DeclarePayload(v[0], new Vector3(v[1], v[2], v[3]), inertia()))
              .thenAcceptAsync(reply -> payloadReason = settled(reply, payload), executor);
    }
  }

  /** The inertia that is shown; empty for that of a point. */
  private Optional<Inertia> inertia() {
    Inertia shown = Inertia.of(Arrays.copyOfRange(payload.values(), INERTIA, payload.size()));
    return shown.equals(Inertia.NONE) ? Optional.empty() : Optional.of(shown);
  }

  /** What was typed is shown until the controller has it; returns why it does not take it. */
  private static String settled(Reply reply, Draft draft) {
    Optional<String> refusal = reply.complaint();
    if (refusal.isEmpty()) {
      draft.reset();
    }
    return refusal.orElse("");
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
    String problem = tcp.problem();
    return problem.isEmpty() ? tcpReason : problem;
  }

  /** What is wrong with the payload that was typed, or worth knowing; empty if nothing. */
  String payloadProblem() {
    String problem = firstOf(payload, payloadReason);
    if (problem.isEmpty() && payload.edited()) {
      problem =
          inertia().flatMap(Inertia::problem).map(why -> text("inertiaProblem", why)).orElse("");
    }
    boolean heavy = payload.edited() && payload.values()[0] > arm.payloadKg();
    return problem.isEmpty() && heavy
        ? text("payloadTooHeavy", arm.payloadKg(), arm.displayName())
        : problem;
  }

  private static String firstOf(Draft draft, String otherwise) {
    String problem = draft.problem();
    return problem.isEmpty() && draft.edited() ? otherwise : problem;
  }
}
