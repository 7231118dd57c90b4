package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.toolpath.ToolConfiguration;
import org.pendant.motion.toolpath.Toolpaths;
import org.pendant.motion.toolpath.nc.NcFile;
import org.pendant.motion.toolpath.nc.NcReader;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Remote TCP and toolpaths (manual 20). */
final class ToolpathBuiltins {
  private static final String MODULE = "processpath";

  private ToolpathBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareSequence(builtins);
    declareMotions(builtins);
    declareFiles(builtins);
  }

  private static void declareSequence(Builtins<ControlBox> builtins) {
    builtins
        .declare("mc_initialize")
        .manual(MODULE, "20.6")
        .doc(
            "Begins a new sequence of motions: numbers count from 0, the part's frame is the"
                + " identity, the speed factor 1. mode 0: the arm holds the tool, tcp is in the"
                + " flange; mode 1: the arm holds the part, tcp is where the tool stands in the"
                + " base. With doc 5 the tool may turn about its z-axis as it likes.")
        .needs("mode", Type.INT)
        .needs("tcp", Type.POSE)
        .takes("doc", Type.INT, Value.of(6))
        .does(ToolpathBuiltins::initialize);
    builtins
        .declare("mc_set_pcs")
        .manual(MODULE, "20.9")
        .doc(
            "Sets the part's frame for motions that are queued from now on: in the base, or in the"
                + " flange when the arm holds the part.")
        .needs("pcs", Type.POSE)
        .does(ToolpathBuiltins::setPcs);
    builtins
        .declare("mc_set_speed_factor")
        .manual(MODULE, "20.10")
        .doc("Sets the part of their speed, 0 to 1, that queued motions have, also while they run.")
        .needs("s", Unit.NONE)
        .does(ToolpathBuiltins::setSpeedFactor);
    builtins
        .declare("mc_get_target_rtcp_speed")
        .manual(MODULE, "20.5")
        .doc(
            "The speed at which the tool that stands still is to go over the part; 0 unless"
                + " mc_initialize has set one.")
        .returns(Unit.METRE_PER_SECOND)
        .does(
            call -> {
              ControlBox box = call.host();
              return call.answer(
                  box.planning()
                      .toolpaths()
                      .remoteSpeedMPerS(box.kinematics().forward(), box.motion()));
            });
    builtins
        .declare("mc_run_motion")
        .manual(MODULE, "20.8")
        .doc(
            "Runs the queued motions up to number id, or all of them, and waits until the last one"
                + " rests at its end.")
        .takes("id", Type.INT, Value.of(-1))
        .physicalTime()
        .does(ToolpathBuiltins::run);
  }

  private static void declareMotions(Builtins<ControlBox> builtins) {
    builtins
        .declare("mc_add_linear")
        .manual(MODULE, "20.3")
        .doc("Queues a straight line of the tool to a pose in the part; answers its number.")
        .needs("pose", Type.POSE)
        .needs("a", Unit.METRE_PER_SECOND_SQUARED)
        .needs("v", Unit.METRE_PER_SECOND)
        .needs("r", Unit.METRE)
        .returns(Type.INT)
        .does(ToolpathBuiltins::addLinear);
    builtins
        .declare("mc_add_circular")
        .manual(MODULE, "20.2")
        .doc(
            "Queues an arc of the tool through a point to a pose in the part; answers its number."
                + " mode 0 turns the tool evenly to the orientation of pose_to, mode 1 keeps it as"
                + " it is to the tangent.")
        .needs("pose_via", Type.POSE)
        .needs("pose_to", Type.POSE)
        .needs("a", Unit.METRE_PER_SECOND_SQUARED)
        .needs("v", Unit.METRE_PER_SECOND)
        .needs("r", Unit.METRE)
        .takes("mode", Type.INT, Value.of(0))
        .returns(Type.INT)
        .does(ToolpathBuiltins::addCircular);
    builtins
        .declare("mc_add_path")
        .manual(MODULE, "20.4")
        .doc(
            "Queues the toolpath of a loaded file; answers its number. v does not count if the feed"
                + " rates of the file do.")
        .needs("path_id", Type.INT)
        .needs("a", Unit.METRE_PER_SECOND_SQUARED)
        .needs("v", Unit.METRE_PER_SECOND)
        .needs("r", Unit.METRE)
        .returns(Type.INT)
        .does(ToolpathBuiltins::addPath);
  }

  private static void declareFiles(Builtins<ControlBox> builtins) {
    builtins
        .declare("mc_load_path")
        .manual(MODULE, "20.7")
        .doc(
            "Reads a .nc file in the programs folder, all of it; answers the number of the path."
                + " useFeedRate says whether the file's feed rates (F) count.")
        .needs("nc_file", Type.STRING)
        .needs("useFeedRate", Type.BOOL)
        .returns(Type.INT)
        .does(ToolpathBuiltins::loadPath);
  }

  private static Toolpaths toolpaths(Call<ControlBox> call) {
    return call.host().planning().toolpaths();
  }

  private static Outcome initialize(Call<ControlBox> call) throws ScriptError {
    boolean remote = call.integer(0, 0, 1) == 1;
    Pose tcp = MotionArguments.pose(call, 1);
    boolean turnFree = call.integer(2, 5, 6) == 5;
    return Planning.named(
        call,
        () -> {
          toolpaths(call).initialize(new ToolConfiguration(remote, tcp), turnFree);
          return call.answer();
        });
  }

  private static Outcome setPcs(Call<ControlBox> call) throws ScriptError {
    Pose pcs = MotionArguments.pose(call, 0);
    return Planning.named(
        call,
        () -> {
          toolpaths(call).setPcs(pcs);
          return call.answer();
        });
  }

  private static Outcome setSpeedFactor(Call<ControlBox> call) throws ScriptError {
    double factor = call.number(0);
    if (!(factor >= 0 && factor <= 1)) {
      throw call.refuse(0, text("zeroToOne"));
    }
    toolpaths(call).setSpeedFactor(factor);
    return call.answer();
  }

  private static Outcome addLinear(Call<ControlBox> call) throws ScriptError {
    Pose to = MotionArguments.pose(call, 0);
    double a = MotionArguments.positive(call, 1);
    double v = MotionArguments.positive(call, 2);
    double r = MotionArguments.notNegative(call, 3);
    return Planning.named(call, () -> call.answerInt(toolpaths(call).addLinear(to, a, v, r)));
  }

  private static Outcome addCircular(Call<ControlBox> call) throws ScriptError {
    Pose via = MotionArguments.pose(call, 0);
    Pose to = MotionArguments.pose(call, 1);
    double a = MotionArguments.positive(call, 2);
    double v = MotionArguments.positive(call, 3);
    double r = MotionArguments.notNegative(call, 4);
    boolean fixed = call.integer(5, 0, 1) == 1;
    return Planning.named(
        call, () -> call.answerInt(toolpaths(call).addCircular(via, to, a, v, r, fixed)));
  }

  private static Outcome addPath(Call<ControlBox> call) throws ScriptError {
    int file = call.integer(0);
    Toolpaths toolpaths = toolpaths(call);
    Optional<Boolean> feeds = toolpaths.feeds(file);
    if (feeds.isEmpty()) {
      String known =
          toolpaths.loaded() == 0 ? text("noPath") : text("zeroTo", toolpaths.loaded() - 1);
      throw call.refuse(0, known);
    }
    double a = MotionArguments.positive(call, 1);
    double v =
        feeds.get() ? MotionArguments.notNegative(call, 2) : MotionArguments.positive(call, 2);
    double r = MotionArguments.notNegative(call, 3);
    if (toolpaths.queuedOtherwise(file, a, v)) {
      call.host().log().warnOnce(text("pathAddedOtherwise", file));
    }
    return Planning.named(call, () -> call.answerInt(toolpaths.addPath(file, a, v, r)));
  }

  private static Outcome loadPath(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    boolean feeds = call.bool(1);
    ControlBox box = call.host();
    return Planning.named(
        call,
        () -> {
          NcFile found =
              new FoundNcFile(
                  box.environment().programsFolder().find(name, ".nc", NcReader.MAX_BYTES));
          return Toolpaths.small(found)
              ? call.answerInt(LoadWait.keep(box, Toolpaths.read(found, feeds), feeds))
              : new LoadWait(box, box.planning().toolpaths().load(found, feeds), feeds);
        });
  }

  private static Outcome run(Call<ControlBox> call) throws ScriptError {
    int id = call.integer(0);
    ControlBox box = call.host();
    return Planning.named(
        call,
        () -> {
          OptionalInt last = box.planning().toolpaths().lastOf(id);
          if (last.isEmpty()) {
            return call.answer();
          }
          if (box.motion().owned()) {
            throw new ScriptError("robot-in-use", text("robotInUse"));
          }
          return new RunWait(box, last.getAsInt());
        });
  }
}
