package org.pendant.protocols.packet;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.quantity.Getter;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.packet.PacketLayout.Slot;

/**
 * Number sources: where the numbers of a layout come from. A quantity of which enough is wanted is
 * read as a whole, of others each component by itself.
 */
final class NumberSources {
  /** Reading one component costs about as much as reading so many of a whole. */
  private static final int COMPONENTS_PER_READ = 3;

  /** How far to look back for a run that continues: further than the parts of a joint. */
  private static final int MAX_RUNS_BACK = 16;

  /** Where each component that is wanted is read to. */
  private final Map<Getter, int[]> places = new HashMap<>();

  private final Scalar[] scalars;
  private final Vector[] vectors;
  private int count;

  /** A component that is read by itself, to {@code at}. */
  private record Scalar(ToDoubleFunction<ControllerState> value, int at) {}

  /** A quantity that is read as a whole, to {@code at} and what follows. */
  private record Vector(Getter getter, int at) {}

  NumberSources(List<Slot> slots) {
    Map<Getter, BitSet> wanted = new HashMap<>();
    for (Slot slot : slots) {
      wanted.computeIfAbsent(slot.getter(), getter -> new BitSet()).set(slot.index());
    }
    List<Scalar> single = new ArrayList<>();
    List<Vector> whole = new ArrayList<>();
    for (Slot slot : slots) {
      Getter getter = slot.getter();
      if (places.containsKey(getter)) {
        continue;
      }
      int[] place = new int[slot.size()];
      places.put(getter, place);
      BitSet components = wanted.get(getter);
      if (!(getter instanceof Getter.OfScalars)
          && components.cardinality() * COMPONENTS_PER_READ >= slot.size()) {
        whole.add(new Vector(getter, count));
        for (int i = 0; i < place.length; i++) {
          place[i] = count++;
        }
      } else {
        for (int i = components.nextSetBit(0); i >= 0; i = components.nextSetBit(i + 1)) {
          single.add(new Scalar(getter.element(i), count));
          place[i] = count++;
        }
      }
    }
    scalars = single.toArray(Scalar[]::new);
    vectors = whole.toArray(Vector[]::new);
  }

  /** How many numbers are read. */
  int count() {
    return count;
  }

  /** Reads the numbers of a snapshot. */
  void read(ControllerState state, double[] numbers) {
    for (Scalar scalar : scalars) {
      numbers[scalar.at] = scalar.value.applyAsDouble(state);
    }
    for (Vector vector : vectors) {
      vector.getter.read(state, numbers, vector.at);
    }
  }

  /** How the numbers go into the packet, in as few pieces as there are. */
  Run[] runs(List<Slot> slots) {
    List<Run> runs = new ArrayList<>();
    for (Slot slot : slots) {
      int from = places.get(slot.getter())[slot.index()];
      int last = runs.size() - 1;
      int found = last;
      while (found >= 0
          && found > last - MAX_RUNS_BACK
          && !runs.get(found).continuesWith(slot.type(), from, slot.at())) {
        found--;
      }
      if (found >= 0 && found > last - MAX_RUNS_BACK) {
        runs.set(found, runs.get(found).with(slot.at()));
      } else {
        runs.add(new Run(slot.type(), from, 1, slot.at(), slot.type().bytes()));
      }
    }
    return runs.toArray(Run[]::new);
  }
}
