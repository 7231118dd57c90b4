package org.pendant.desktop.move;

/**
 * Jog step: how far the arm moves at one press of a button.
 *
 * @param lengthM for moves along an axis, m
 * @param angleRad for turns, rad
 */
record JogStep(double lengthM, double angleRad) {}
