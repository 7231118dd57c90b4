package org.pendant.controller;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.box.CellStation;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.ArmlessBuiltins;
import org.pendant.controller.device.EncoderLines;
import org.pendant.controller.device.ToolPlaces;
import org.pendant.controller.io.Signals;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.rule.Rules;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.ArmSurroundings;
import org.pendant.controller.world.CellWorld;
import org.pendant.controller.world.CellWorld.Standing;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SeenScene;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.script.function.Builtins;

/**
 * Cell: controllers that share what stands around their arms. One thread lets time pass for all of
 * them, in the same frames of 2 ms:
 *
 * <ol>
 *   <li>rules and wires answer what was set in the frame before;
 *   <li>each controller begins its frame, and its devices with it;
 *   <li>each arm says where it will be, and then the objects move;
 *   <li>each controller runs its frame, in the order of the file.
 * </ol>
 *
 * <p>What one controller sets the others see in the next frame, so the order counts for nothing but
 * the order of what happens within one frame. The same plan and the same programs give the same
 * bits in every run.
 *
 * <p>A debugger that pauses one of the programs holds all of them. Each call lets every controller
 * take its commands once, in that order, so that commands at the same places have another cell of
 * the same plan do the same.
 */
public final class Cell implements Frames {
  private static final int NOBODY = -1;

  /**
   * One of the controllers.
   *
   * @param name what signals, messages and files call it
   * @param options it was switched on with: what stands around it is in the frame of its base
   * @param baseInCell where its base stands; the origin for one without an arm
   * @param armless whether it has no arm: it runs the cell's script
   */
  public record Member(
      String name,
      Controller controller,
      ControllerOptions options,
      Pose baseInCell,
      boolean armless) {}

  private final List<Member> members = new ArrayList<>();
  private final CellWorld world;
  private final Rules rules;
  private final WireBoard wires;

  /** Whose program a debugger has paused in the frame that has begun. */
  private int heldMember = NOBODY;

  /**
   * Switches the controllers of a cell on.
   *
   * @param plan of more than one controller
   * @param options of each controller, in the order of {@link
   *     org.pendant.controller.layout.CellLayout#names}; the arm is the one that they say, and what
   *     stands around it the plan's
   * @param builtins that programs of arms may call
   * @throws JsonException if the plan cannot be followed, with the place in its file
   */
  public Cell(CellPlan plan, List<ControllerOptions> options, Builtins<ControlBox> builtins)
      throws JsonException {
    List<ArmEntry> arms = plan.arms();
    List<String> names = plan.layout().names();
    List<Standing> standing = new ArrayList<>();
    for (int i = 0; i < arms.size(); i++) {
      standing.add(standing(plan, arms.get(i), placed(options.get(i), arms.get(i))));
    }
    world = world(plan, standing);
    ToolPlaces tools = new ToolPlaces();
    EncoderLines encoders = new EncoderLines();
    List<Signals> signals = names.stream().map(_ -> new Signals()).toList();
    SignalLines lines = new SignalLines(signals.getFirst().digital());
    for (int i = 0; i < names.size(); i++) {
      lines.add(names.get(i), signals.get(i).digital());
    }
    for (int i = 0; i < names.size(); i++) {
      boolean armless = i >= arms.size();
      CellStation station =
          new CellStation(
              signals.get(i),
              lines.of(signals.get(i).digital()),
              armless ? world.withoutArm() : world.contacts(i),
              armless ? Optional.empty() : Optional.of(world.neighbours(i)),
              armless ? Optional.empty() : world.encounters(i),
              tools,
              encoders,
              armless);
      ControllerOptions placed =
          options.get(i).withEquipment(plan.equipment().devices().get(i)).withStation(station);
      ControllerOptions own =
          armless
              ? placed.withScene(Scene.EMPTY).withArm(ArmChoice.IDEAL)
              : placed.withScene(standing.get(i).scene());
      Controller controller =
          armless ? new Controller(own, ArmlessBuiltins.create()) : arm(own, arms.get(i), builtins);
      members.add(
          new Member(
              names.get(i),
              controller,
              own,
              armless ? Pose.ZERO : arms.get(i).baseInCell(),
              armless));
    }
    rules = new Rules(plan.equipment().rules(), lines, new CellDeviceActions(members));
    wires = new WireBoard(plan.equipment().wires(), lines);
  }

  /** What an arm is switched on with where the file may say where it starts. */
  private static ControllerOptions placed(ControllerOptions options, ArmEntry entry) {
    return entry.startRad().map(options::withStart).orElse(options);
  }

  private static Standing standing(CellPlan plan, ArmEntry entry, ControllerOptions options)
      throws JsonException {
    try {
      Scene seen = entry.equipped(SeenScene.of(plan.scene(), entry.baseInCell()));
      return new Standing(
          entry.name(),
          options.arm(),
          seen,
          options.startRad(),
          entry.baseInCell(),
          options.armChoice() != ArmChoice.IDEAL);
    } catch (IllegalArgumentException e) {
      throw entry.place().refusal(entry.name() + ": " + e.getMessage());
    }
  }

  private static CellWorld world(CellPlan plan, List<Standing> standing) throws JsonException {
    try {
      return new CellWorld(plan.scene(), standing);
    } catch (IllegalArgumentException e) {
      throw plan.arms().getLast().place().refusal(e.getMessage());
    }
  }

  private static Controller arm(
      ControllerOptions options, ArmEntry entry, Builtins<ControlBox> builtins)
      throws JsonException {
    try {
      Controller controller = new Controller(placed(options, entry), builtins);
      mount(controller, entry.baseInCell());
      return controller;
    } catch (IllegalArgumentException e) {
      throw entry.place().refusal(entry.name() + ": " + e.getMessage());
    }
  }

  /** A base that does not stand upright feels gravity from another side. */
  private static void mount(Controller controller, Pose baseInCell) {
    double[] base12 = new double[Transforms.SIZE];
    Transforms.of(baseInCell, base12);
    if (base12[8] < 1) {
      double g = ArmDynamics.STANDARD_GRAVITY_M_PER_S2;
      controller.box().arm().setGravity(g * base12[6], g * base12[7], g * base12[8]);
    }
  }

  /** The controllers, in their order. */
  public List<Member> members() {
    return List.copyOf(members);
  }

  /**
   * What the links of an arm can get into, links of the other arms included; its own, for whoever
   * asks, who says where all arms are.
   */
  public static ArmSurroundings surroundings(Member arm) {
    return arm.controller().box().arm().neighbours().surroundings();
  }

  @Override
  public void advance() {
    advance(false);
  }

  @Override
  public void advanceBeforeCommands() {
    advance(true);
  }

  private void advance(boolean beforeCommands) {
    int from = Math.max(0, heldMember);
    if (heldMember == NOBODY) {
      begin();
    }
    heldMember = NOBODY;
    for (int i = 0; i < members.size(); i++) {
      Controller controller = members.get(i).controller();
      if (i < from || heldMember != NOBODY) {
        // has run its frame already, or waits for the one whose program is paused
        controller.applyCommands();
      } else {
        advance(controller, beforeCommands);
        heldMember = controller.held() ? i : NOBODY;
      }
    }
  }

  private static void advance(Controller controller, boolean beforeCommands) {
    if (beforeCommands) {
      controller.advanceBeforeCommands();
    } else {
      controller.advance();
    }
  }

  private void begin() {
    rules.step();
    wires.step();
    for (int i = 0; i < members.size(); i++) {
      members.get(i).controller().beginFrame();
    }
    for (int i = 0; i < members.size(); i++) {
      if (!members.get(i).armless()) {
        members.get(i).controller().box().arm().simulated().place();
      }
    }
    world.advance();
  }

  @Override
  public void applyCommands() {
    if (heldMember != NOBODY) {
      advance();
      return;
    }
    members.forEach(each -> each.controller().applyCommands());
  }

  @Override
  public boolean waitsForOutside() {
    return members.stream().anyMatch(each -> each.controller().waitsForOutside());
  }

  @Override
  public boolean needsNoFrameOnTime() {
    return members.stream().allMatch(each -> each.controller().needsNoFrameOnTime());
  }

  @Override
  public boolean followed() {
    return members.stream().anyMatch(each -> each.controller().followed());
  }

  @Override
  public boolean held() {
    return heldMember != NOBODY;
  }

  @Override
  public void wakeBy(Runnable wake) {
    members.forEach(each -> each.controller().wakeBy(wake));
  }

  @Override
  public void noteLostTime(double sinceStartS) {
    // time is that of all: the log of the first says so
    for (int i = 0; i < members.size(); i++) {
      members.get(i).controller().noteLostTime(sinceStartS, i == 0);
    }
  }
}
