/**
 * World: what stands around the arm and is mounted on its flange, and the forces that come of
 * touching it. Open {@link org.pendant.controller.world.ContactWorld} first, then {@link
 * org.pendant.controller.world.Scene}, which it is built from.
 */
package org.pendant.controller.world;
