package org.pendant.controller.builtin;

import java.util.List;
import org.pendant.controller.box.ArmModel;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.dynamics.PayloadEstimate;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Payload builtins: what is mounted on the flange: declared, asked for and estimated (manual 16.2,
 * 16.26 to 16.52).
 */
final class PayloadBuiltins {
  private static final String MODULE = "internals";
  private static final String SUCCESSOR = "set_target_payload";
  private static final List<String> ESTIMATE = List.of("mass", "cog");

  private PayloadBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareReading(builtins);
    declareDeprecated(builtins);
    builtins
        .declare("set_target_payload")
        .manual(MODULE, "16.52")
        .doc(
            "Declares the payload: mass, centre of gravity from the flange, inertia about that as"
                + " [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] in kg m\u00b2, and how long it takes to change"
                + " over. The force sensor is zeroed when it has.")
        .needs("m", Unit.KILOGRAM)
        .needs("cog", Type.LIST)
        .takes("inertia", Type.LIST, NumberList.ofInts(0, 0, 0, 0, 0, 0))
        .takes("transition_time", Unit.SECOND, 0)
        .does(PayloadBuiltins::setTargetPayload);
    builtins
        .declare("estimate_payload")
        .manual(MODULE, "16.2")
        .doc(
            "Mass and centre of gravity of what hangs on the flange beyond the declared payload, as"
                + " struct(mass, cog). poses are at least four poses of the TCP, turned well"
                + " against each other; wrenches is what get_tcp_force gave at rest in each,"
                + " as poses or as lists.")
        .needs("poses", Type.LIST)
        .needs("wrenches", Type.LIST)
        .returns(Type.STRUCT)
        .does(PayloadBuiltins::estimate);
  }

  private static void declareReading(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_target_payload")
        .manual(MODULE, "16.26")
        .doc("The mass of the payload that was declared last.")
        .returns(Unit.KILOGRAM)
        .does(call -> call.answer(declared(call).massKg()));
    builtins
        .declare("get_target_payload_cog")
        .manual(MODULE, "16.27")
        .doc("The centre of gravity of the payload that was declared last, from the flange, in m.")
        .returns(Type.LIST)
        .does(PayloadBuiltins::cog);
    builtins
        .declare("get_target_payload_inertia")
        .manual(MODULE, "16.28")
        .doc(
            "The inertia [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] of the payload that was declared last,"
                + " about its centre of gravity along the axes of the flange, in kg m\u00b2.")
        .returns(Type.LIST)
        .does(PayloadBuiltins::inertia);
  }

  private static void declareDeprecated(Builtins<ControlBox> builtins) {
    builtins
        .declare("set_payload")
        .manual(MODULE, "16.49")
        .doc(
            "Declares mass and centre of gravity of a payload without inertia. Without cog the"
                + " centre of gravity is the TCP, also after later calls of set_tcp.")
        .needs("m", Unit.KILOGRAM)
        .mayTake("cog", Type.LIST, Unit.METRE, "active tcp")
        .deprecated(SUCCESSOR)
        .does(PayloadBuiltins::setPayload);
    builtins
        .declare("set_payload_cog")
        .manual(MODULE, "16.50")
        .doc("Moves the centre of gravity of the declared payload and forgets its inertia.")
        .needs("CoG", Type.LIST)
        .deprecated(SUCCESSOR)
        .does(PayloadBuiltins::setCog);
    builtins
        .declare("set_payload_mass")
        .manual(MODULE, "16.51")
        .doc(
            "Changes the mass of the declared payload, keeps its centre of gravity and forgets its"
                + " inertia.")
        .needs("m", Unit.KILOGRAM)
        .deprecated(SUCCESSOR)
        .does(PayloadBuiltins::setMass);
  }

  private static Payload declared(Call<ControlBox> call) {
    return call.host().arm().model().targetPayload();
  }

  private static Outcome cog(Call<ControlBox> call) {
    Payload payload = declared(call);
    return call.answer(NumberList.of(payload.cogXM(), payload.cogYM(), payload.cogZM()));
  }

  private static Outcome inertia(Call<ControlBox> call) {
    Payload p = declared(call);
    return call.answer(NumberList.of(p.ixx(), p.iyy(), p.izz(), p.ixy(), p.ixz(), p.iyz()));
  }

  private static Outcome setPayload(Call<ControlBox> call) throws ScriptError {
    double massKg = PayloadArguments.massKg(call, 0);
    if (!call.given(1)) {
      call.host().flange().declarePayloadAtTool(massKg);
      return call.answer();
    }
    double[] cogM = PayloadArguments.cogM(call, 1);
    return declare(call, Payload.of(massKg, cogM[0], cogM[1], cogM[2]), 0);
  }

  private static Outcome setCog(Call<ControlBox> call) throws ScriptError {
    double[] cogM = PayloadArguments.cogM(call, 0);
    return declare(call, Payload.of(declared(call).massKg(), cogM[0], cogM[1], cogM[2]), 0);
  }

  private static Outcome setMass(Call<ControlBox> call) throws ScriptError {
    Payload before = declared(call);
    double massKg = PayloadArguments.massKg(call, 0);
    return declare(call, Payload.of(massKg, before.cogXM(), before.cogYM(), before.cogZM()), 0);
  }

  private static Outcome setTargetPayload(Call<ControlBox> call) throws ScriptError {
    double massKg = PayloadArguments.massKg(call, 0);
    double[] cogM = PayloadArguments.cogM(call, 1);
    double[] i = PayloadArguments.inertiaKgM2(call, 2);
    Payload payload =
        new Payload(massKg, cogM[0], cogM[1], cogM[2], i[0], i[1], i[2], i[3], i[4], i[5]);
    return declare(call, payload, MotionArguments.notNegative(call, 3));
  }

  private static Outcome declare(Call<ControlBox> call, Payload payload, double transitionS) {
    call.host().flange().declarePayload(payload, transitionS);
    return call.answer();
  }

  private static Outcome estimate(Call<ControlBox> call) throws ScriptError {
    ArmModel model = call.host().arm().model();
    PayloadEstimate estimate =
        PayloadEstimate.of(
            PayloadArguments.flangesInBase(call, 0),
            PayloadArguments.wrenches(call, 1),
            model.feltAccelerationMPerS2(0),
            model.feltAccelerationMPerS2(1),
            model.feltAccelerationMPerS2(2));
    return switch (estimate) {
      case PayloadEstimate.Refused refused -> throw call.failure("no-estimate", refused.reason());
      case PayloadEstimate.Found found -> call.answer(struct(found.payload()));
    };
  }

  private static StructValue struct(Payload payload) {
    return StructValue.owning(
        ESTIMATE,
        Value.of(payload.massKg()),
        NumberList.of(payload.cogXM(), payload.cogYM(), payload.cogZM()));
  }
}
