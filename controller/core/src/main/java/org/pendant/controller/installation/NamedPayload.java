package org.pendant.controller.installation;

import org.pendant.controller.box.Inertia;
import org.pendant.controller.world.Vector3;

/**
 * Payload with a name.
 *
 * @param name its own among all payloads
 * @param massKg what hangs on the flange
 * @param cogM its centre of gravity in the flange frame, m
 * @param inertia about the centre of gravity
 */
public record NamedPayload(String name, double massKg, Vector3 cogM, Inertia inertia) {}
