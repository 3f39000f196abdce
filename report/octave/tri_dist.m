% SPDX-License-Identifier: GPL-3.0-or-later
% tri_dist.m: the algorithm of Tri_dist.m (Ruggiero 2001, Appendix 1) in our own words, with the parameters that the
% paper prints. `octave-cli tri_dist.m` writes tri_dist.json into the working folder.
%
% It computes the displacement of the half-space's surface by eq. (3) at the eleven points of Fig. 5, and steps off
% the points 0 and c, where a logarithm has no value, by 1e-7 in, as the printed program does.
1;  % a script, though functions come first

% Eq. (3) without its constant, and the sum of the magnitudes of its terms, which its rounding goes with.
function [u, magnitude] = displacement(x, peak, c, young, poisson)
  factor = (1 - poisson^2) / (2 * pi * young) * peak / c;
  terms = [(x + c)^2 * log(((x + c) / c)^2), (x - c)^2 * log(((x - c) / c)^2), -2 * x^2 * log((x / c)^2)];
  u = -factor * sum(terms);
  magnitude = factor * sum(abs(terms));
end

peak = 1000;   % psi; the program's P, which stands where eq. (3) has p0
c = 0.010;     % in
young = 30e6;  % psi
poisson = 0.30;
datum = 10;    % in
step = 1e-7;   % in

x = (0:10) * 0.005;
x(1) = step;
x(3) = 0.01 + step;
[at_datum, datum_magnitude] = displacement(datum, peak, c, young, poisson);
for i = 1:11
  [u(i), magnitude] = displacement(x(i), peak, c, young, poisson);
  u(i) -= at_datum;
  % Each term has some six operations, and its logarithm a relative error that the argument's rounding makes; near c
  % the logarithm is large where its factor is small.
  abs_error(i) = 16 * eps * (magnitude + datum_magnitude);
end

comma = {",", ""};
script = [mfilename(), ".m"];
file = fopen("tri_dist.json", "w");
fprintf(file, "{\n  \"script\": \"%s\",\n", script);
fprintf(file, "  \"script_sha256\": \"%s\",\n", hash("sha256", fileread(mfilename("fullpathext"))));
fprintf(file, "  \"values\": {\n    \"octave-version\": {\"text\": \"GNU Octave %s\"}", version());
for i = 1:11
  fprintf(file, ",\n    \"u%d\": {\"value\": %.17g, \"abs_error\": %.2g, \"unit\": \"in\", \"digits\": 8}", i, u(i),
          abs_error(i));
end
fprintf(file, "\n  },\n  \"tables\": {\n    \"displacement\": {\n      \"columns\": [\n");
fprintf(file, "        {\"heading\": \"$x$\", \"unit\": \"in\", \"decimals\": 7, \"exact\": true},\n");
fprintf(file, "        {\"heading\": \"$u_z$\", \"unit\": \"in\", \"digits\": 8}\n      ],\n      \"rows\": [\n");
for i = 1:11
  fprintf(file, "        [%.17g, {\"value\": %.17g, \"abs_error\": %.2g}]%s\n", x(i), u(i), abs_error(i),
          comma{1 + (i == 11)});
end
fprintf(file, "      ]\n    }\n  }\n}\n");
fclose(file);
