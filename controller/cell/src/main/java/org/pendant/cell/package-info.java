/** Rigid bodies around the arm: how they fall, collide, slide, stack and press. */
package org.pendant.cell;
