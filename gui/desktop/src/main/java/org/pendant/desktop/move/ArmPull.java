package org.pendant.desktop.move;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Vector3;

/**
 * Arm pull: the hand that pulls the arm in a picture of it. While freedrive is on, the user who has
 * switched it on, the arm follows; otherwise this one switches it on for the drag, if that is
 * wanted. One thread uses it.
 */
public final class ArmPull {
  private final RepeatedCommand freedrive;
  private final RepeatedCommand pull;
  private Optional<ControllerState> state = Optional.empty();
  private Optional<Obstacle> obstacle = Optional.empty();
  private Optional<Grip> grip = Optional.empty();
  private boolean wanted;
  private Optional<String> reason = Optional.empty();

  /** Where the arm is held. */
  private record Grip(int link, Vector3 pointInLinkM) {
    Command towards(Vector3 placeInBaseM) {
      return new WorldCommand.PullLink(link, pointInLinkM, placeInBaseM);
    }
  }

  /**
   * Nothing is held.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   */
  public ArmPull(Function<Command, CompletableFuture<Reply>> submit, Executor executor) {
    freedrive = new RepeatedCommand(submit, executor, new ManualCommand.EndFreedrive());
    pull = new RepeatedCommand(submit, executor, new WorldCommand.LetGo());
  }

  /** Whether every drag on the arm pulls it. */
  public boolean wanted() {
    return wanted;
  }

  /** From now on every drag on the arm pulls it, or only one with the key for it. */
  public void setWanted(boolean pulls) {
    wanted = pulls;
  }

  /**
   * Whether a drag that begins on the arm now pulls it.
   *
   * @param key whether the key for it is held
   */
  public boolean grabs(boolean key) {
    return wanted || key || on();
  }

  private boolean on() {
    return state.map(now -> now.freedrive().active()).orElse(false);
  }

  /** Takes the newest snapshot, and repeats what is held; about 30 times a second. */
  public void take(ControllerState newest, Pace pace) {
    state = Optional.of(newest);
    obstacle = Obstacle.of(newest, pace);
    if (grip.isEmpty()) {
      return;
    }
    if (freedrive.refused()) {
      giveUp(freedrive.reason());
    } else if (pull.refused()) {
      giveUp(pull.reason());
    } else if (!freedrive.held() && !on()) {
      guide();
    }
    freedrive.repeat();
    pull.repeat();
  }

  /** The arm is held; see {@link WorldCommand.PullLink}. */
  public void begin(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) {
    end();
    grip = Optional.of(new Grip(link, pointInLinkM));
    if (!on()) {
      guide();
    }
    grip.ifPresent(held -> pull.begin(held.towards(placeInBaseM)));
  }

  /** Switches freedrive on, unless something is in the way. */
  private void guide() {
    if (obstacle.isPresent()) {
      giveUp(obstacle.get().text());
    } else {
      freedrive.begin(new ManualCommand.StartFreedrive(FreeAxes.ALL, FreedriveFrame.BASE));
    }
  }

  private void giveUp(String why) {
    end();
    reason = Optional.of(why.endsWith(".") ? why : JointNames.sentence(why));
  }

  /** The arm is pulled to another place. */
  public void move(Vector3 placeInBaseM) {
    grip.ifPresent(held -> pull.change(held.towards(placeInBaseM)));
  }

  /** Whether the arm is held. */
  public boolean pulls() {
    return grip.isPresent();
  }

  /** The arm is let go. */
  public void end() {
    grip = Optional.empty();
    pull.release();
    freedrive.release();
  }

  /** Why the arm has not been pulled, or not any further; told once, then empty. */
  public Optional<String> newReason() {
    Optional<String> told = reason;
    reason = Optional.empty();
    return told;
  }
}
