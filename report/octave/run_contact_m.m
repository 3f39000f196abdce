% SPDX-License-Identifier: GPL-3.0-or-later
% run_contact_m.m: runs the listing contact_m.m and writes what it computes, with bounds of its rounding, as
% contact_m.json into the working folder: `octave-cli run_contact_m.m`. The listing itself leaves Numer.out there.
1;  % a script, though functions come first

% The listing ends with a plot, which needs no window here.
function figure(varargin) end
function subplot(varargin) end
function plot(varargin) end

warning("off", "Octave:legacy-function");  % the listing's inline
contact_m;  % begins with `clear`, so nothing may be kept from before

% Bound how far rounding moves the pressures: an entry of B is a difference of two coefficients of some magnitude
% m = |terms| + |const|, each with 16 roundings, and to first order |δp| ≤ |B⁻¹| |δB| |p|.
magnitude = (1 - v^2) / (2 * pi * EE * c) * 4 * (nn * c)^2 * abs(log((nn * 2)^2)) + 2 * abs(const);
rounding = 2 * 16 * eps * magnitude * ones(nn);
rounding(1, :) = 4 * eps * A;
rounding(aa:nn, :) = 0;
p_error = abs(inv(B)) * (rounding * abs(p) + 4 * eps * abs(h));

script = "contact_m.m";
comma = {",", ""};
file = fopen("contact_m.json", "w");
fprintf(file, "{\n  \"script\": \"%s\",\n", script);
fprintf(file, "  \"script_sha256\": \"%s\",\n", hash("sha256", fileread(which("contact_m"))));
fprintf(file, "  \"values\": {\n    \"octave-version\": {\"text\": \"GNU Octave %s\"}", version());
fprintf(file, ",\n    \"load\": {\"value\": %.17g, \"abs_error\": %.2g, \"unit\": \"lbf/in\"}", c * sum(p),
        c * sum(p_error));
for i = 1:aa - 1
  fprintf(file, ",\n    \"p%d\": {\"value\": %.17g, \"abs_error\": %.2g, \"unit\": \"psi\"}", i, p(i), p_error(i));
end
inputs = {"P", "lbf/in", P; "c", "in", c; "EE", "psi", EE; "v", "", v; "R1", "in", R1; "R2", "in", R2; "n", "", n};
for i = 1:rows(inputs)
  fprintf(file, ",\n    \"%s\": {\"value\": %.17g, \"abs_error\": 0", inputs{i, 1}, inputs{i, 3});
  if (! isempty(inputs{i, 2}))
    fprintf(file, ", \"unit\": \"%s\"", inputs{i, 2});
  endif
  fprintf(file, "}");
end
fprintf(file, ",\n    \"zero-node\": {\"value\": %d, \"abs_error\": 0}", aa);
fprintf(file, ",\n    \"hertz-half-width\": {\"value\": %.17g, \"abs_error\": %.2g, \"unit\": \"in\"}", a, 8 * eps * a);
fprintf(file, ",\n    \"hertz-peak\": {\"value\": %.17g, \"abs_error\": %.2g, \"unit\": \"psi\"}", p0, 8 * eps * p0);
fprintf(file, "\n  },\n  \"tables\": {\n    \"pressure\": {\n      \"columns\": [\n");
fprintf(file, "        {\"heading\": \"node\", \"integer\": true},\n");
fprintf(file, "        {\"heading\": \"$p$\", \"unit\": \"psi\", \"decimals\": 1}\n      ],\n      \"rows\": [\n");
for i = 1:nn
  fprintf(file, "        [%d, {\"value\": %.17g, \"abs_error\": %.2g}]%s\n", i, p(i), p_error(i), comma{1 + (i == nn)});
end
fprintf(file, "      ]\n    }\n  }\n}\n");
fclose(file);
