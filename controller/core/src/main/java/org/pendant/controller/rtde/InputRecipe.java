package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Input recipe: which inputs a client writes together, and in which order their values come. */
public final class InputRecipe {
  private final List<InputField> fields;
  private final Set<String> names;
  private final List<String> claims;
  private final int bytes;

  /** A recipe of these inputs. One that is named twice counts as it comes last. */
  public InputRecipe(List<InputField> fields) {
    this.fields = List.copyOf(fields);
    names = fields.stream().map(InputField::name).collect(Collectors.toUnmodifiableSet());
    claims = fields.stream().flatMap(field -> field.claims().stream()).distinct().toList();
    bytes = fields.stream().mapToInt(field -> field.type().bytes()).sum();
  }

  /** The inputs, in the order of their values. */
  public List<InputField> fields() {
    return fields;
  }

  /** The names of the inputs. */
  public Set<String> names() {
    return names;
  }

  /** What a client must have taken to write all of them. */
  public List<String> claims() {
    return claims;
  }

  /** How many bytes the values take. */
  public int bytes() {
    return bytes;
  }

  /**
   * Takes the values out of a package.
   *
   * @param values big-endian, exactly {@link #bytes} of them
   * @throws IllegalArgumentException if there are fewer or more
   */
  public InputUpdate decode(ByteBuffer values) {
    if (values.remaining() != bytes) {
      throw new IllegalArgumentException(
          "the values take " + values.remaining() + " bytes, must be " + bytes);
    }
    InputGathering gathering = new InputGathering();
    for (InputField field : fields) {
      field.decoder().take(values, gathering);
    }
    return gathering.finish(this);
  }
}
