package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.room;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ListValueTest {

  @Test
  void storingAFloatTurnsIntsIntoFloats() throws ScriptError {
    NumberList list = NumberList.owning(new double[] {1, 2, 0}, 2, ValueKind.INT);
    list.append(Value.of(0.5));
    assertEquals(ValueKind.FLOAT, list.elementKind());
    assertEquals("[1, 2, 0.5]", list.text());
  }

  @Test
  void aFailedAppendChangesNothing() {
    NumberList full = ints(1);
    assertThrows(ScriptError.class, () -> full.appendNumber(0.5, ValueKind.FLOAT));
    assertThrows(ScriptError.class, () -> full.append(Value.of("a")));
    assertEquals(ValueKind.INT, full.elementKind());
    assertEquals(ints(1), full);
  }

  @Test
  void aListExtendsByItself() throws ScriptError {
    NumberList numbers = NumberList.owning(new double[] {1, 2, 0, 0}, 2, ValueKind.INT);
    numbers.extend(numbers);
    assertEquals(ints(1, 2, 1, 2), numbers);
    ObjectList words = ObjectList.owning(new Value[] {Value.of("a"), null}, 1, Value.of(""));
    words.extend(words);
    assertEquals(strings("a", "a"), words);
  }

  @Test
  void extendingTakesAllOrNothing() throws ScriptError {
    NumberList list = room(2);
    assertThrows(ScriptError.class, () -> list.extend(ints(1, 2, 3)));
    assertThrows(ScriptError.class, () -> list.extend(bools(true)));
    assertThrows(ScriptError.class, () -> list.extend(strings("a")));
    assertEquals(0, list.length());
    list.extend(strings());
    list.extend(floats(1, 2));
    assertEquals(floats(1, 2), list);
  }

  @Test
  void partsOfAListAreCopies() throws ScriptError {
    ListValue list = (ListValue) list(struct("n", 1), struct("n", 2));
    ((StructValue) list.slice(0, 1).open(0)).set("n", Value.of(9));
    ((StructValue) list.copy().open(1)).set("n", Value.of(9));
    assertEquals("[{n = 1}, {n = 2}]", list.text());
  }

  @Test
  void capacityDoesNotCountInComparison() {
    assertEquals(ints(), room(5));
    assertEquals(ints().hashCode(), room(5).hashCode());
    assertNotEquals(ints(0), room(5));
  }

  @Test
  void randomEditsFollowAPlainList() throws ScriptError {
    SplittableRandom random = new SplittableRandom(3);
    NumberList numbers = room(8);
    ListValue words = ObjectList.owning(new Value[8], 0, Value.of(""));
    List<Integer> model = new ArrayList<>();
    for (int step = 0; step < 10_000; step++) {
      int place = random.nextInt(model.size() + 1);
      if (random.nextInt(5) < 3 && model.size() < 8) {
        numbers.insert(place, Value.of(step));
        words.insert(place, Value.of("" + step));
        model.add(place, step);
      } else if (place < model.size()) {
        numbers.remove(place);
        words.remove(place);
        model.remove(/* index */ place);
      }
      assertEquals(model.toString(), numbers.text());
      assertEquals(model.toString(), words.text().replace("\"", ""));
    }
  }
}
