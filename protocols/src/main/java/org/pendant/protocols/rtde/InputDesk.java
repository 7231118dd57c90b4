package org.pendant.protocols.rtde;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.Reply;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.InputUpdate;

/** The inputs that one client writes. For the client's own thread, which may wait. */
final class InputDesk {
  /** Their numbers have one byte, and 0 is none. */
  static final int MOST_RECIPES = 255;

  /** A client that writes more than so many packages a frame waits for the frame. */
  private static final int MOST_IN_A_FRAME = 8;

  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final long PATIENCE_S = 5;

  /** When to ask again, ms. */
  private static final long AGAIN_MS = 2;

  private final Controller controller;
  private final String client;
  private final List<InputRecipe> recipes = new ArrayList<>();
  private final Semaphore room = new Semaphore(MOST_IN_A_FRAME);

  /** What was wrong with the last package of each recipe. */
  private final Map<Integer, String> complaints = new HashMap<>();

  InputDesk(Controller controller, String client) {
    this.controller = controller;
    this.client = client;
  }

  /** Whether there may be another recipe. */
  boolean hasRoom() {
    return recipes.size() < MOST_RECIPES;
  }

  /** Keeps a recipe whose inputs are {@link #claim claimed}; answers its number, from 1. */
  int add(InputRecipe recipe) {
    recipes.add(recipe);
    return recipes.size();
  }

  /** Takes all inputs of a recipe, unless somebody else has some of them, which are answered. */
  Set<String> claim(InputRecipe recipe) throws InterruptedException {
    CompletableFuture<Set<String>> inUse = new CompletableFuture<>();
    ask(new Command.ClaimInputs(client, recipe, inUse::complete));
    // a box that does not answer gives nothing away
    return inUse.getNow(recipe.names());
  }

  /** Has a command carried out that is refused only while too many others wait. */
  private void ask(Command command) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!(answer(command) instanceof Reply.Done) && System.nanoTime() < endNs) {
      TimeUnit.MILLISECONDS.sleep(AGAIN_MS);
    }
  }

  private Reply answer(Command command) throws InterruptedException {
    try {
      return controller.submit(command).get(PATIENCE_S, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      return new Reply.Refused("the controller does not answer");
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Writes a package in the next frame.
   *
   * @return what there is to complain about, unless the package before had the same mistake
   */
  Optional<String> write(Request.Data data) throws InterruptedException {
    List<String> mistakes = tryToWrite(data);
    if (mistakes.isEmpty()) {
      complaints.remove(data.recipe());
      return Optional.empty();
    }
    String complaint = String.join("; ", mistakes);
    return complaint.equals(complaints.put(data.recipe(), complaint))
        ? Optional.empty()
        : Optional.of(complaint);
  }

  private List<String> tryToWrite(Request.Data data) throws InterruptedException {
    int number = data.recipe();
    if (number < 1 || number > recipes.size()) {
      return List.of("there is no input recipe " + number);
    }
    InputRecipe recipe = recipes.get(number - 1);
    if (data.values().remaining() != recipe.bytes()) {
      return List.of(
          "the values of input recipe "
              + number
              + " take "
              + data.values().remaining()
              + " bytes, must be "
              + recipe.bytes());
    }
    InputUpdate update = recipe.decode(data.values());
    submit(update);
    return update.ignored();
  }

  private void submit(InputUpdate update) throws InterruptedException {
    if (room.tryAcquire(PATIENCE_S, TimeUnit.SECONDS)) {
      var _ =
          controller
              .submit(new Command.WriteInputs(client, update))
              .whenComplete((answer, failure) -> room.release());
    }
  }

  /** Gives all inputs back; their values stay. */
  void release() throws InterruptedException {
    ask(new Command.ReleaseSignals(client));
  }
}
