package org.pendant.controller.rtde;

/**
 * Something that RTDE clients may write.
 *
 * @param name such as {@code input_int_register_3}
 * @param claim under which name a client takes it, so that nobody else may write it; see {@link
 *     org.pendant.controller.io.InputOwners}
 */
public record InputField(String name, FieldType type, String claim) {}
